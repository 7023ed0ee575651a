// A surface that is mapped to the sphere, with what finds places of it.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "fit/sphere_location.h"
#include "fit/surface_distance.h"
#include "fit/surface_mesh.h"
#include "fit/triangle_distance.h"

namespace interleaf {

/// Zero for a triangle of no area.
glm::dvec3 unit_normal(const TriangleCorners& corners);

/// Barycentric coordinates of places of a triangle: the grid that divides each edge into \p parts, without
/// the corners.
template <int parts>
constexpr auto barycentric_grid() {
    std::array<glm::dvec3, (parts + 1) * (parts + 2) / 2 - 3> places{};
    std::size_t count = 0;
    for (int i = 0; i < parts; ++i)
        for (int j = i == 0 ? 1 : 0; j < parts && i + j <= parts; ++j)
            places[count++] = {double(i) / parts, double(j) / parts, double(parts - i - j) / parts};
    return places;
}

struct MappedSurface {
    /// Both must outlive this. \pre fault_of_map() finds none
    MappedSurface(const SurfaceMesh& mesh, std::span<const glm::dvec3> points);

    glm::dvec3 position(const MeshPoint& point) const {
        return point.of(std::span(mesh.triangles), std::span(mesh.positions));
    }

    const SurfaceMesh& mesh;             ///< closed, of genus 0
    std::span<const glm::dvec3> points;  ///< its map to the unit sphere, one a vertex, one to one
    SphereLocation location;             ///< by that map
    SurfaceDistance distance;            ///< from the mesh
    std::vector<glm::dvec3> normals;     ///< unit, one a triangle; zero where it has no area
};

}  // namespace interleaf
