#include "render/surface_values.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "hierarchy/surface_measures.h"

namespace interleaf {
namespace {

/// The part of the vertices whose curvature the scale covers; some have hardly any area.
constexpr double covered_part = 0.95;

/// The size that the covered part of \p values stays below.
float covered_size(std::vector<float> values) {
    if (values.empty()) return 0;
    for (float& value : values) value = std::abs(value);
    const auto place = static_cast<std::ptrdiff_t>(covered_part * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), values.begin() + place, values.end());
    return values[static_cast<std::size_t>(place)];
}

/// A range from \p min to \p max, or one around it where that has no length.
ValueRange range_of(float min, float max) {
    return max > min ? ValueRange{min, max} : ValueRange{min, min + 1};
}

}  // namespace

bool is_measured(Coloring coloring) {
    return coloring == Coloring::angle || coloring == Coloring::curvature || coloring == Coloring::moved;
}

SurfaceValues surface_values(Coloring coloring, const UnionMesh& mesh, std::span<const glm::vec3> positions) {
    if (coloring == Coloring::angle) return {ValuePlace::leaf, smallest_angles(mesh.triangles, positions)};
    if (coloring == Coloring::curvature)
        return {ValuePlace::vertex, mean_curvatures(mesh.triangles, positions)};
    return {ValuePlace::vertex, distances(mesh.positions.front(), positions)};
}

ColorScale measured_scale(Coloring coloring, const UnionMesh& mesh) {
    if (coloring == Coloring::angle) return {.map = ColorMap::viridis, .range = {0, 60}};
    float largest = 0;
    for (const Buffer<glm::vec3>& positions : mesh.positions) {
        if (coloring == Coloring::curvature) {
            largest = std::max(largest, covered_size(mean_curvatures(mesh.triangles, positions)));
        } else {
            for (const float distance : distances(mesh.positions.front(), positions))
                largest = std::max(largest, distance);
        }
    }
    if (coloring == Coloring::curvature)
        return {.map = ColorMap::coolwarm, .range = range_of(-largest, largest)};
    return {.map = ColorMap::viridis, .range = range_of(0, largest)};
}

}  // namespace interleaf
