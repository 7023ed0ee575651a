// The colors and scalars of a mesh at the points of a sampled surface.
#pragma once

#include <vector>

#include "fit/mesh/surface_mesh.h"
#include "fit/sampling/mapped_surface.h"
#include "fit/sampling/surface_sampling.h"
#include "hierarchy/hierarchy.h"

namespace interleaf {

/// \param mesh     with the colors and scalars
/// \param mapped   \p mesh itself, or a finer mesh of the same surface (surface_refinement.h)
/// \param surface  sampled from \p mapped
/// \return the field "color" if the mesh has colors, then its scalars, except for one of that name
std::vector<Field> sampled_fields(const SurfaceMesh& mesh, const MappedSurface& mapped,
                                  const SampledSurface& surface);

}  // namespace interleaf
