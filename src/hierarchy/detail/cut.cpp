#include "hierarchy/detail/cut.h"

#include <algorithm>
#include <cassert>
#include <cstdint>
#include <functional>

namespace interleaf {

Hierarchy cut(const Hierarchy& hierarchy, std::span<const float> errors, float threshold) {
    assert(errors.size() == hierarchy.vertex_count());
    struct Node {
        Triangle vertices;
        std::uint8_t level;
        bool is_kept;  ///< false below a leaf of the cut
    };
    std::vector<Leaf> leaves;
    std::vector<Node> pending;
    std::size_t position = 0;
    auto next_midpoint = hierarchy.midpoints.begin();
    for (const Triangle& root : hierarchy.roots.triangles()) {
        pending.push_back({root, 0, true});
        while (!pending.empty()) {
            const auto [vertices, level, is_kept] = pending.back();
            pending.pop_back();
            const bool is_bisected = hierarchy.is_bisected(position++);
            const Index midpoint = is_bisected ? *next_midpoint++ : no_index;
            const bool stays_bisected = is_kept && is_bisected && errors[midpoint] > threshold;
            if (is_kept && !stays_bisected) leaves.push_back({vertices, level});
            if (!is_bisected) continue;
            const auto [first, second] = bisect(vertices, midpoint);
            const auto below = static_cast<std::uint8_t>(level + 1);
            pending.push_back({second, below, stays_bisected});
            pending.push_back({first, below, stays_bisected});
        }
    }
    return hierarchy_from_leaves(hierarchy.roots, leaves, hierarchy.positions, hierarchy.fields);
}

CutSizes::CutSizes(const Hierarchy& hierarchy, std::span<const float> errors)
    : root_count_(hierarchy.roots.triangle_count()) {
    assert(errors.size() == hierarchy.vertex_count());
    // Every bisection adds a leaf.
    std::vector<float> sorted;
    sorted.reserve(hierarchy.midpoints.size());
    for (const Index midpoint : hierarchy.midpoints) sorted.push_back(errors[midpoint]);
    std::ranges::sort(sorted, std::greater());
    for (std::size_t n = 0; n < sorted.size(); ++n) {
        if (n == 0 || sorted[n] != sorted[n - 1]) steps_.push_back({sorted[n], 0});
        steps_.back().leaves = root_count_ + n + 1;
    }
}

std::size_t CutSizes::leaf_count(float threshold) const {
    const auto below = std::ranges::partition_point(
        steps_, [threshold](const Step& step) { return step.error > threshold; });
    return below == steps_.begin() ? root_count_ : (below - 1)->leaves;
}

float CutSizes::threshold(std::size_t max_leaves) const {
    assert(max_leaves >= root_count_);
    const auto beyond = std::ranges::partition_point(
        steps_, [max_leaves](const Step& step) { return step.leaves <= max_leaves; });
    return beyond == steps_.end() ? keep_everything : beyond->error;
}

float CutSizes::distance(float threshold) const {
    const auto dropped = std::ranges::partition_point(
        steps_, [threshold](const Step& step) { return step.error > threshold; });
    return dropped == steps_.end() ? 0 : dropped->error;
}

}  // namespace interleaf
