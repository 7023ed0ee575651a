// A surface that is mapped to the sphere, with what finds places of it.
#pragma once

#include <array>
#include <span>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "fit/mesh/space_triangle.h"
#include "fit/mesh/surface_distance.h"
#include "fit/mesh/surface_mesh.h"
#include "fit/sampling/sphere_location.h"

namespace interleaf {

struct MappedSurface {
    /// Both must outlive this. \pre that of SphereLocation
    MappedSurface(const SurfaceMesh& surface, std::span<const glm::dvec3> map);

    glm::dvec3 position(const MeshPoint& point) const {
        return point.of(std::span(mesh.triangles), std::span(mesh.positions));
    }

    const SurfaceMesh& mesh;             ///< closed, of genus 0
    std::span<const glm::dvec3> points;  ///< its map to the unit sphere, one a vertex, one to one
    SphereLocation location;             ///< by that map
    SurfaceDistance distance;            ///< from the mesh
    std::vector<glm::dvec3> normals;     ///< unit, one a triangle; zero where it has no area
};

/// A place of a leaf, and the place of the surface that the map has there.
struct FacingPlaces {
    glm::dvec3 on_leaf;
    glm::dvec3 on_surface;
    Index triangle;  ///< of the surface
};

/// Whether \p is_fine(const FacingPlaces&) says so at all places of a grid; it is called until it says no.
/// \param grid        barycentric coordinates, see barycentric_grid()
/// \param directions  of the corners of the leaf, on the sphere
/// \param corners     where they lie in space
/// \param guess       a triangle of the surface near one of them
template <typename IsFine>
bool all_of_places(const MappedSurface& mapped, std::span<const glm::dvec3> grid,
                   const std::array<glm::dvec3, 3>& directions, const TriangleCorners& corners, Index guess,
                   IsFine is_fine) {
    const auto at = [](const glm::dvec3& place, const std::array<glm::dvec3, 3>& values) {
        return place[0] * values[0] + place[1] * values[1] + place[2] * values[2];
    };
    for (const glm::dvec3& place : grid) {
        const MeshPoint point = mapped.location.locate(glm::normalize(at(place, directions)), guess);
        guess = point.triangle;
        if (!is_fine(FacingPlaces{at(place, corners), mapped.position(point), point.triangle})) return false;
    }
    return true;
}

}  // namespace interleaf
