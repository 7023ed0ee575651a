// A picture of where the roots of a key do not match those of another: the key's surface with the root
// filled, a tube along the edge or a ball at the vertex, and a camera from where they can be seen. No GL.
#pragma once

#include <string>

#include "family/synchronize_keys.h"
#include "hierarchy/union_mesh.h"
#include "hierarchy/vertex_normals.h"
#include "render/camera.h"

namespace interleaf {

/// A place among the roots of a key; what there is none of has no_index.
struct RootPlace {
    Index root = no_index;
    RootMismatch::Edge edge = {no_index, no_index};
    Index vertex = no_index;
};

/// Where \p mismatch is in the key, and where its counterpart in the reference.
RootPlace place_in_key(const RootMismatch& mismatch);
RootPlace place_in_reference(const RootMismatch& mismatch);

/// "bone: root 12, edge (3, 7)"; the name alone for no place.
std::string caption_of(const std::string& name, const RootPlace& place);

/// What a renderer draws with weight 1, and Coloring::field for the colors.
struct MismatchPicture {
    UnionMesh mesh;  ///< of one key; leaves in the place's root have vertices of their own, behind the key's,
                     ///< and the tube or ball is at the end
    NormalForm form;         ///< of the mesh
    UnionField colors;       ///< of the mesh
    std::size_t leaf_count;  ///< triangles of the key, the first ones
    Camera camera;
};

/// sRGB-encoded: of the root, and of the edge or vertex in it.
inline constexpr glm::vec3 mismatch_root_color{0.98F, 0.78F, 0.28F};
inline constexpr glm::vec3 mismatch_edge_color{0.86F, 0.10F, 0.12F};

/// The picture of \p key for width / height = \p aspect. Without a root in \p place, the whole key and
/// nothing marked. \pre key passes check(), and has what \p place names, edge and vertex in its root
MismatchPicture mismatch_picture(const Hierarchy& key, const RootPlace& place, float aspect);

}  // namespace interleaf
