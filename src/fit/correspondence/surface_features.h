// Functions on a surface by which places of two bodies are compared: smoothed normals, and how central a place
// is.
#pragma once

#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "fit/mesh/progress_meter.h"
#include "hierarchy/triangle.h"

namespace interleaf {

/// The sum of the cross products of the triangles at each vertex, as a unit vector; 0 where they cancel.
std::vector<glm::dvec3> vertex_normals(std::span<const Triangle> triangles,
                                       std::span<const glm::dvec3> positions);

/// Spreads a field by one implicit step of the heat equation with linear elements, and normalizes it.
/// \param field   unit vectors, one per vertex
/// \param radius  how far values spread, in the unit of \p positions
/// \throw Cancelled
std::vector<glm::dvec3> smoothed_directions(std::span<const Triangle> triangles,
                                            std::span<const glm::dvec3> positions,
                                            std::span<const glm::dvec3> field, double radius,
                                            ProgressMeter& meter);

/// The mean distance along the surface of all places from each vertex, scaled to 0 (the middle of the body) to
/// 1 (the tip farthest out): Hilaga et al. 2001. Distances run along edges and across pairs of triangles, from
/// 32 vertices that lie far apart, each of which stands for the area nearest to it.
/// \param begin, end  the fractions of the whole work at which the measuring begins and ends
/// \throw Cancelled
std::vector<double> outwardness(std::span<const Triangle> triangles, std::span<const glm::dvec3> positions,
                                double begin, double end, ProgressMeter& meter);

}  // namespace interleaf
