// The distance of points from a triangle mesh.
//
// A box around a long thin triangle is mostly empty unless the triangle lies along an axis. So the search tree
// has several boxes per long triangle, one for each strip of it (compare the early split clipping of Ernst and
// Greiner 2007). Distances are measured to whole triangles, so the strips do not change them.
#pragma once

#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "fit/mesh/box_tree.h"
#include "fit/mesh/space_triangle.h"
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

    /// Whether \p point is at most \p distance from the mesh. This is much quicker than the distance of a point that is
    /// farther away.
    /// \param near  a triangle that is tried first; receives one within the distance, if there is one
    bool is_within(const glm::dvec3& point, double distance, Index& near) const;

    /// The nearest point of the mesh.
    /// \param nearest  as above
    glm::dvec3 nearest_point(const glm::dvec3& point, Index& nearest) const;

  private:
    TriangleCorners corners(Index triangle) const;
    std::vector<SpaceBox> boxes_of_strips();

    std::span<const Triangle> triangles_;
    std::span<const glm::dvec3> positions_;
    std::vector<Index> triangle_of_box_;
    BoxTree tree_;
};

}  // namespace interleaf
