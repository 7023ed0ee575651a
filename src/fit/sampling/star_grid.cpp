#include "fit/sampling/star_grid.h"

#include <algorithm>

namespace interleaf {
namespace {

constexpr int coarse_parts = 4;
constexpr int fine_parts = 2 * coarse_parts;

/// The places of the grid that divides each edge into \p parts.
std::vector<glm::dvec3> star_grid(int parts) {
    std::vector<glm::dvec3> places;
    for (int i = 0; i < parts; ++i)
        for (int j = i == 0 ? 1 : 0; i + j < parts; ++j)
            places.push_back({double(i) / parts, double(j) / parts, double(parts - i - j) / parts});
    return places;
}

}  // namespace

StarGrids::StarGrids() : coarse(star_grid(coarse_parts)), between(star_grid(fine_parts)) {
    std::erase_if(between,
                  [&](const glm::dvec3& place) { return std::ranges::find(coarse, place) != coarse.end(); });
}

}  // namespace interleaf
