// The places at which smoothing measures the distance between the star of a vertex and a surface.
#pragma once

#include <vector>

#include <glm/vec3.hpp>

namespace interleaf {

/// Places on each leaf of a star, on a fine grid: first those of a coarse grid, which rule out most moves. The first
/// barycentric coordinate belongs to the middle of the star. The edge to the second corner is left out, because the next
/// leaf of the star has it.
struct StarGrids {
    StarGrids();

    std::vector<glm::dvec3> coarse;
    std::vector<glm::dvec3> between;  ///< the places of the fine grid that the coarse one lacks
};

}  // namespace interleaf
