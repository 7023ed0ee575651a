// Where a direction meets a surface that is mapped to the unit sphere.
//
// The vertices of a closed mesh lie on the sphere so that its triangles, as cones from the origin, cover
// every direction once (spherical_map.h). A direction lies in one of these cones; its coordinates there are
// those of the point in which its ray meets the flat triangle, so the map is linear on each triangle.
#pragma once

#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "fit/mesh/box_tree.h"
#include "hierarchy/triangle.h"

namespace interleaf {

/// Six times the volume of the tetrahedron (origin, a, b, p): positive when p lies to the left of the way
/// from a to b, seen from outside. Made of differences, so it is exact enough also where the three are close.
inline double side_of_arc(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& p) {
    return glm::dot(a, glm::cross(b - a, p - a));
}

/// A point of a triangle mesh.
struct MeshPoint {
    Index triangle = no_index;
    glm::dvec3 barycentric{0};  ///< in the order of the triangle's vertices; not negative, sum 1

    /// The value there of what is linear on the triangle. \p values holds one a vertex.
    template <typename Value>
    Value of(std::span<const Triangle> triangles, std::span<const Value> values) const {
        const auto& [a, b, c] = triangles[triangle];
        using Number = typename Value::value_type;
        return values[a] * static_cast<Number>(barycentric[0]) +
               values[b] * static_cast<Number>(barycentric[1]) +
               values[c] * static_cast<Number>(barycentric[2]);
    }
};

class SphereLocation {
  public:
    /// \param points  of the unit sphere, one a vertex of \p triangles; both must outlive this
    /// \pre fault_of_map() finds none, and every vertex has a triangle
    /// \throw InputError when the triangles are no closed surface (half_edge_mesh.h)
    SphereLocation(std::span<const Triangle> triangles, std::span<const glm::dvec3> points);

    /// The point in \p direction, of length 1. Where rounding puts an edge's direction in neither triangle,
    /// the one it is least outside of has it: there is an answer for every direction. \p guess may name a
    /// triangle that is likely near, which saves time: the way is walked from there, triangle by triangle.
    MeshPoint locate(const glm::dvec3& direction, Index guess = no_index) const;

  private:
    glm::dvec3 volumes(Index triangle, const glm::dvec3& direction) const;

    std::span<const Triangle> triangles_;
    std::span<const glm::dvec3> points_;
    std::vector<Triangle> neighbors_;  ///< across the edges opposite to the corners
    BoxTree tree_;
};

}  // namespace interleaf
