// A picture that shows where the roots of a key do not match those of another: the key's surface with the
// root filled, a tube along the edge or a ball at the vertex, and a camera that sees them. No GL.
#pragma once

#include <string>

#include "family/synchronize_keys.h"
#include "hierarchy/union_mesh.h"
#include "hierarchy/vertex_normals.h"
#include "render/camera.h"

namespace interleaf {

/// A place among the roots of a key. Missing parts are no_index.
struct RootPlace {
    Index root = no_index;
    RootMismatch::Edge edge = {no_index, no_index};
    Index vertex = no_index;
};

/// The place of \p mismatch in the key, and its counterpart in the reference.
RootPlace place_in_key(const RootMismatch& mismatch);
RootPlace place_in_reference(const RootMismatch& mismatch);

/// A caption such as "bone: root 12, edge (3, 7)"; only the name for an empty place.
std::string caption_of(const std::string& name, const RootPlace& place);

/// The data for a renderer, with weight 1, and Coloring::field for the colors.
struct MismatchPicture {
    UnionMesh mesh;          ///< of one key; leaves of the root have vertices of their own, after the key's,
                             ///< and the tube or ball is at the end
    NormalForm form;         ///< of the mesh
    UnionField colors;       ///< of the mesh
    std::size_t leaf_count;  ///< number of the key's triangles, which come first
    Camera camera;
};

/// The colors, sRGB-encoded, of the root, and of the edge or vertex in it.
inline constexpr glm::vec3 mismatch_root_color{0.98F, 0.78F, 0.28F};
inline constexpr glm::vec3 mismatch_edge_color{0.86F, 0.10F, 0.12F};

/// The picture of \p key. Without a root in \p place, it shows the whole key without marks.
/// \param aspect  width / height of the picture
/// \pre           key passes check(), and has the root, edge and vertex of \p place; edge and vertex belong
///                to the root
MismatchPicture mismatch_picture(const Hierarchy& key, const RootPlace& place, float aspect);

}  // namespace interleaf
