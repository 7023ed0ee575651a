// Maps a clean mesh of genus 0 to the unit sphere, one to one, and checks such maps.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "fit/mesh/progress.h"
#include "fit/mesh/surface_mesh.h"
#include "fit/sphere_map/spherical_star.h"

namespace interleaf {

/// The ways to map, in the order in which they are tried.
enum class MapMethod { progressive, careful_progressive, curvature_flow };

struct SphericalMap {
    std::vector<glm::dvec3> points;  ///< unit, one a vertex of the mesh
    MapMethod method = MapMethod::progressive;
};

/// Maps \p mesh, which must be clean (see clean_up.h), one to one to the unit sphere. The same mesh gives the
/// same bits. Time grows about linearly with the vertices; memory is about 400 bytes a vertex.
/// \throw InputError when the mesh is not clean, or when every way fails, with the reason
/// \throw Cancelled  when \p progress says so
/// \param crowded  where surroundings of new vertices are relaxed at once (progressive_map.h). On fine meshes
/// of
///                 long thin bodies vertices come back along the body, each into the star of the last, and
///                 without it shrink by a factor each. 0 for meshes that are as coarse as the body allows.
SphericalMap map_to_sphere(const SurfaceMesh& mesh, const Progress& progress, Keeps keeps = Keeps::areas,
                           double crowded = 0);

/// Empty when every spherical triangle is positive and the solid angles add up to exactly one 4 pi, that is,
/// when the map is one to one; else the reason in words. The signs are those of exact arithmetic.
std::string fault_of_map(const SurfaceMesh& mesh, std::span<const glm::dvec3> points);

/// Moves \p points by the Moebius map of the sphere that brings the surface's center of mass on the sphere to
/// the sphere's center (Baden, Crane and Kazhdan 2018), as far as the map stays one to one.
void center_map(const SurfaceMesh& mesh, std::vector<glm::dvec3>& points);

}  // namespace interleaf
