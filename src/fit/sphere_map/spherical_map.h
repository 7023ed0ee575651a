// Maps a clean mesh of genus 0 to the unit sphere, one to one, and checks such maps.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "fit/mesh/surface_mesh.h"
#include "fit/sphere_map/spherical_star.h"
#include "hierarchy/progress.h"

namespace interleaf {

/// The mapping methods, in the order in which they are tried.
enum class MapMethod { progressive, careful_progressive, curvature_flow };

struct SphericalMap {
    std::vector<glm::dvec3> points;  ///< unit vectors, one per vertex of the mesh
    MapMethod method = MapMethod::progressive;
};

/// Maps \p mesh one to one to the unit sphere. The same mesh gives the same bits. Time grows about linearly
/// with the number of vertices. Memory is about 400 bytes per vertex.
/// \param mesh       clean (clean_up.h)
/// \param crowded    where the surroundings of new vertices are relaxed at once (progressive_map.h). On fine
///                   meshes of long thin bodies, vertices return along the body, each into the star of the
///                   last one. Without this relaxation each star is smaller than the last by some factor. 0
///                   for meshes that are as coarse as the body allows.
/// \throw InputError if the mesh is not clean, or if every method fails, with the reason
/// \throw Cancelled  when \p progress says so
SphericalMap map_to_sphere(const SurfaceMesh& mesh, const Progress& progress, Keeps keeps = Keeps::areas,
                           double crowded = 0);

/// The reason, in words, why a map is not one to one. Empty if the map is one to one: every spherical
/// triangle is positive, and the solid angles add up to exactly one 4 pi. The signs are those of exact
/// arithmetic.
std::string fault_of_map(const SurfaceMesh& mesh, std::span<const glm::dvec3> points);

/// Moves \p points by the Moebius map of the sphere that brings the surface's center of mass on the sphere to
/// the center of the sphere (Baden, Crane and Kazhdan 2018), as far as the map stays one to one.
void center_map(const SurfaceMesh& mesh, std::vector<glm::dvec3>& points);

}  // namespace interleaf
