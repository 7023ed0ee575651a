// Continues the map of a surface that moves and is meshed anew: each vertex of the new mesh takes over the point on
// the sphere of the nearest place of the surface before. So points of the surface hardly slide from step to step, while
// maps that are made for each mesh alone differ by as much as the meshes do.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "fit/mesh/surface_mesh.h"
#include "hierarchy/progress.h"

namespace interleaf {

struct ContinuedMapOptions {
    std::size_t vertices = 8000;  ///< at least wanted in the mesh, about evenly
    double worst_shape =
        4;  ///< shapes on the sphere are restored where their distortion is larger (finished_map.h)
};

struct ContinuedMap {
    SurfaceMesh mesh;                ///< the given mesh with long edges halved, without colors and scalars
    std::vector<glm::dvec3> points;  ///< of the unit sphere, one per vertex of that mesh; one to one
};

/// The surface before is compared as it is, or moved to the same center of area, or scaled to the same area, too: as
/// the two surfaces are nearest to each other. Triangles that turn over are untangled, and shapes on the sphere are
/// restored where they are bad.
/// \param before    clean
/// \param points    the map of \p before: of the unit sphere, one per vertex, one to one
/// \param mesh      clean
/// \return          without points if the surfaces are too far from each other, or if the map is not one to one
/// \throw InputError  if a surface has no area
/// \throw Cancelled
ContinuedMap continued_map(const SurfaceMesh& before, std::span<const glm::dvec3> points,
                           const SurfaceMesh& mesh, const ContinuedMapOptions& options,
                           const Progress& progress);

}  // namespace interleaf
