// The distance of points from a triangle mesh.
#pragma once

#include <span>

#include <glm/vec3.hpp>

#include "fit/mesh/box_tree.h"
#include "hierarchy/triangle.h"

namespace interleaf {

class SurfaceDistance {
  public:
    /// \p positions holds one a vertex of \p triangles; both must outlive this. \pre there is a triangle
    SurfaceDistance(std::span<const Triangle> triangles, std::span<const glm::dvec3> positions);

    /// The distance of \p point from the mesh, or from some of its triangles where that is \p enough or less.
    /// \p nearest is where the nearest triangle goes; what it names before is tried first, which saves time
    /// when points come in order.
    double operator()(const glm::dvec3& point, Index& nearest, double enough = 0) const;

  private:
    double squared_distance(const glm::dvec3& point, Index triangle) const;

    std::span<const Triangle> triangles_;
    std::span<const glm::dvec3> positions_;
    BoxTree tree_;
};

}  // namespace interleaf
