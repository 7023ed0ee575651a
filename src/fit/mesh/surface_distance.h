// The distance of points from a triangle mesh.
#pragma once

#include <span>

#include <glm/vec3.hpp>

#include "fit/mesh/box_tree.h"
#include "hierarchy/triangle.h"

namespace interleaf {

class SurfaceDistance {
  public:
    /// \param triangles  at least one; must outlive this object
    /// \param positions  one per vertex of \p triangles; must outlive this object
    SurfaceDistance(std::span<const Triangle> triangles, std::span<const glm::dvec3> positions);

    /// The distance of \p point from the mesh; or its distance from some of the triangles, if that is at most
    /// \p enough.
    /// \param nearest  receives the nearest triangle. The search tries the triangle that it holds first,
    ///                 which saves time when points come in order.
    double operator()(const glm::dvec3& point, Index& nearest, double enough = 0) const;

  private:
    double squared_distance(const glm::dvec3& point, Index triangle) const;

    std::span<const Triangle> triangles_;
    std::span<const glm::dvec3> positions_;
    BoxTree tree_;
};

}  // namespace interleaf
