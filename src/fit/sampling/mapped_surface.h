// A surface that is mapped to the sphere, with the search structures that find places on it.
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

/// A point of a surface that a key is to show in the direction into which the map takes it.
struct MappedLandmark {
    glm::dvec3 direction;
    glm::dvec3 position;
};

struct MappedSurface {
    /// \param surface    must outlive this object
    /// \param map        must outlive this object; meets the precondition of SphereLocation
    /// \param landmarks  positions; their nearest points of the surface are meant
    MappedSurface(const SurfaceMesh& surface, std::span<const glm::dvec3> map,
                  std::span<const glm::dvec3> landmarks = {});

    glm::dvec3 position(const MeshPoint& point) const {
        return point.of(std::span(mesh.triangles), std::span(mesh.positions));
    }
    /// The unit vector in the direction of a point.
    glm::dvec3 direction(const MeshPoint& point) const {
        return glm::normalize(point.of(std::span(mesh.triangles), points));
    }
    /// The point of the surface that is nearest to \p place.
    MeshPoint nearest_point(const glm::dvec3& place) const;

    const SurfaceMesh& mesh;             ///< closed, of genus 0
    std::span<const glm::dvec3> points;  ///< the map to the unit sphere, one per vertex, one to one
    SphereLocation location;             ///< in this map
    SurfaceDistance distance;            ///< from the mesh
    std::vector<glm::dvec3> normals;     ///< unit vectors, one per triangle; zero for triangles without area
    std::vector<MappedLandmark> landmarks;
};

/// A place on a leaf, and the place on the surface that the map puts there.
struct FacingPlaces {
    glm::dvec3 on_leaf;
    glm::dvec3 on_surface;
    Index triangle;  ///< of the surface
};

/// Whether \p is_fine(const FacingPlaces&) is true at all places of a grid. The calls end at the first false.
/// \param grid        barycentric coordinates, see barycentric_grid()
/// \param directions  of the corners of the leaf, on the sphere
/// \param corners     of the leaf, in space
/// \param guess       a triangle of the surface near one of the corners
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
