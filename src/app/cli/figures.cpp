#include "app/cli/figures.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <vector>

namespace interleaf {

Figures figures_of(const Hierarchy& key, std::uintmax_t file) {
    const std::vector<Leaf> leaves = leaves_of(key);
    std::vector<Triangle> triangles;
    triangles.reserve(leaves.size());
    for (const Leaf& leaf : leaves) triangles.push_back(leaf.vertices);
    const auto [lowest, highest] = std::ranges::minmax(leaves, {}, &Leaf::level);
    return {.roots = key.roots.triangle_count(),
            .leaves = key.leaf_count(),
            .vertices = key.vertex_count(),
            .min_level = lowest.level,
            .max_level = highest.level,
            .memory = key.byte_count(),
            .file = file,
            .min_angle = measure(triangles, key.positions).min_angle,
            .euler = key.roots.euler_number(),
            .boundary = key.roots.boundary_edge_count(),
            .box = bounding_box(key.positions)};
}

Figures total(std::span<const Figures> keys) {
    return std::accumulate(keys.begin() + 1, keys.end(), keys.front(), [](Figures sum, const Figures& key) {
        sum.leaves += key.leaves;
        sum.vertices += key.vertices;
        sum.min_level = std::min(sum.min_level, key.min_level);
        sum.max_level = std::max(sum.max_level, key.max_level);
        sum.memory += key.memory;
        sum.file += key.file;
        sum.min_angle = std::min(sum.min_angle, key.min_angle);
        sum.box = bounding_box(std::array{sum.box.min, sum.box.max, key.box.min, key.box.max});
        return sum;
    });
}

}  // namespace interleaf
