// Mean distances along a surface: small in the middle of a body, large at its tips (Hilaga et al. 2001).
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "fit/mesh/progress_meter.h"
#include "fit/mesh/surface_graph.h"
#include "hierarchy/triangle.h"

namespace interleaf {

/// A third of the area of the triangles at each vertex.
std::vector<double> vertex_areas(std::span<const Triangle> triangles, std::span<const glm::dvec3> positions);

/// Per vertex, the mean distance of all other points, by area. It is measured from \p bases vertices that lie far
/// apart, each of which stands for the area that is nearer to it than to the others.
/// \param graph  of the same vertices
/// \param areas  one per vertex
/// \param bases  at least 1; at most the number of vertices counts
/// \param begin, end  the fractions of the whole work at which the measuring begins and ends
/// \throw Cancelled
std::vector<double> mean_distances(const SurfaceGraph& graph, std::span<const double> areas,
                                   std::size_t bases, double begin, double end, ProgressMeter& meter);

}  // namespace interleaf
