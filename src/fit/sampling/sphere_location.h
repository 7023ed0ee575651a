// Finds where a direction meets a surface that is mapped to the unit sphere.
//
// The vertices of a closed mesh lie on the sphere so that its triangles, as cones from the origin, cover
// every direction once (spherical_map.h). So a direction lies in one cone. The coordinates of the direction
// in the cone are those of the point where its ray meets the flat triangle, so the map is linear on each
// triangle.
#pragma once

#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "fit/mesh/box_tree.h"
#include "hierarchy/triangle.h"

namespace interleaf {

/// Six times the volume of the tetrahedron (origin, a, b, p): positive if p lies to the left of the arc from
/// a to b, seen from outside. It is computed from differences, so it is accurate even if the three points are
/// close together.
inline double side_of_arc(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& p) {
    return glm::dot(a, glm::cross(b - a, p - a));
}

/// A point of a triangle mesh.
struct MeshPoint {
    Index triangle = no_index;
    glm::dvec3 barycentric{0};  ///< in the order of the triangle's vertices; not negative, sum 1

    /// The value at this point of a function that is linear on the triangle.
    /// \param values  one per vertex
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
    /// \param triangles  must outlive this object
    /// \param points     of the unit sphere, one per vertex of \p triangles; must outlive this object
    /// \pre              fault_of_map() finds no fault, and every vertex has a triangle
    /// \throw InputError if the triangles are not a closed surface (half_edge_mesh.h)
    SphereLocation(std::span<const Triangle> triangles, std::span<const glm::dvec3> points);

    /// The point in \p direction. Where rounding puts the direction of an edge in neither triangle, the
    /// result is in the triangle that the direction misses by less, so there is an answer for every
    /// direction.
    /// \param direction  of length 1
    /// \param guess      a triangle that is probably near, which saves time: the search walks from there,
    ///                   triangle by triangle
    MeshPoint locate(const glm::dvec3& direction, Index guess = no_index) const;

  private:
    glm::dvec3 volumes(Index triangle, const glm::dvec3& direction) const;

    std::span<const Triangle> triangles_;
    std::span<const glm::dvec3> points_;
    std::vector<Triangle> neighbors_;  ///< across the edges opposite the corners
    BoxTree tree_;
};

}  // namespace interleaf
