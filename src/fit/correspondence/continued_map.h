// Continues the map of a surface that moves and is meshed anew: each vertex of the new mesh takes over the point on
// the sphere of the nearest place of the surface before. So points of the surface hardly slide from step to step, while
// maps that are made for each mesh alone differ by as much as the meshes do.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "fit/correspondence/sphere_mesh.h"
#include "fit/mesh/surface_mesh.h"
#include "hierarchy/progress.h"

namespace interleaf {

/// A map before its shapes are restored.
struct ContinuedMap {
    SurfaceMesh mesh;                ///< the given mesh with long edges halved, without colors and scalars
    SphereMesh body;                 ///< the same mesh, scaled to the area 1; its own points mean nothing
    std::vector<glm::dvec3> points;  ///< of the unit sphere, one per vertex of that mesh
};

/// The map of \p mesh that continues the map of the surface before, \p before. The search for nearest places takes the
/// surface before as it is, or moved to the center of area of \p mesh, or moved and scaled to the area of \p mesh:
/// whichever is nearest to \p mesh. Triangles that turn over are untangled.
/// \param before    clean
/// \param points    the map of \p before: of the unit sphere, one per vertex, one to one
/// \param mesh      clean
/// \param vertices  long edges of \p mesh are halved until it has at least this number of vertices
/// \return          without points if the surfaces are too far from each other
/// \throw InputError  if a surface has no area
/// \throw Cancelled
ContinuedMap continued_map(const SurfaceMesh& before, std::span<const glm::dvec3> points,
                           const SurfaceMesh& mesh, std::size_t vertices, const Progress& progress);

/// The points of \p map with shapes on the sphere restored where they are bad.
/// \param map          with points
/// \param worst_shape  shapes are restored where their distortion is larger (finished_map.h)
/// \return             one to one; none if the map is not
/// \throw Cancelled
std::vector<glm::dvec3> with_restored_shapes(const ContinuedMap& map, double worst_shape,
                                             const Progress& progress);

}  // namespace interleaf
