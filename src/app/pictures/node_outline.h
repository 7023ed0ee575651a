// The outline of a node of the hierarchy over a picture of a surface: its sides along the surface, where the
// surface shows them and where it hides them.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include <glm/vec3.hpp>

#include "app/pictures/picture_depths.h"
#include "hierarchy/nodes/node_index.h"
#include "hierarchy/nodes/node_path.h"
#include "hierarchy/triangle.h"
#include "hierarchy/union_mesh.h"
#include "render/camera.h"
#include "ui/widgets/outline_marks.h"

namespace interleaf {

class NodeOutline {
  public:
    /// Distinguishes the meshes that follow() is given.
    using MeshNumber = std::pair<bool, std::size_t>;

    /// Position of a vertex of the mesh.
    using Positions = std::function<glm::vec3(Index vertex)>;

    /// \param node  none for no outline
    /// \pre  the root of \p node exists in \p mesh
    void follow(const UnionMesh& mesh, MeshNumber number, const std::optional<NodePath>& node);

    bool is_shown() const { return node_.has_value(); }

    /// The corners of the node.
    /// \param positions  of the mesh of the last follow()
    /// \pre is_shown()
    std::array<glm::vec3, 3> corners(const Positions& positions) const;

    /// The outline in pixels.
    /// \param positions  of the mesh of the last follow()
    /// \pre is_shown()
    Outline outline(const Positions& positions, const Camera& camera, const PictureDepths& picture) const;

  private:
    std::optional<NodePath> node_;
    MeshNumber number_;
    std::optional<NodeIndex> index_;
    std::array<std::vector<SurfacePoint>, 3> sides_;
};

}  // namespace interleaf
