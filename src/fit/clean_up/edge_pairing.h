// Finds the neighbors of triangles that need be neither a manifold nor oriented.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "fit/mesh/progress_meter.h"
#include "hierarchy/triangle.h"

namespace interleaf {

struct EdgePairing {
    std::vector<Index> twin;  ///< per half-edge 3 t + k, from corner k to the next; no_index at a boundary
    std::size_t crowded_edges = 0;  ///< edges at which more than two triangles met
};

/// Pairs the half-edges at each edge. Where more than two triangles meet, the function pairs the two
/// triangles that bound one wedge of the solid inside, so that solids that touch along an edge are separated.
/// A half-edge without a partner becomes boundary.
EdgePairing pair_edges(std::span<const glm::dvec3> positions, std::span<const Triangle> triangles,
                       ProgressMeter& meter);

}  // namespace interleaf
