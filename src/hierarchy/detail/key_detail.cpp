#include "hierarchy/detail/key_detail.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <span>

#include "hierarchy/detail/bisection_forest.h"
#include "hierarchy/detail/cut.h"
#include "hierarchy/detail/normal_cones.h"
#include "hierarchy/detail/vertex_errors.h"

namespace interleaf {

namespace {

/// The bisections, first those with the errors of the highest power of two, and among these in preorder.
std::vector<Index> order_by_error(const BisectionForest& forest, std::span<const float> errors) {
    std::vector<int> powers;
    powers.reserve(forest.bisections.size());
    for (const Bisection& each : forest.bisections) powers.push_back(std::ilogb(errors[each.midpoint]));
    std::vector<Index> order(forest.bisections.size());
    std::iota(order.begin(), order.end(), Index{0});
    std::ranges::stable_sort(order, [&](Index a, Index b) { return powers[a] > powers[b]; });
    return order;
}

float sine_of(const NormalCone& cone) {
    return cone.half_angle < std::numbers::pi_v<float> / 2 ? std::sin(cone.half_angle) : 2;
}

}  // namespace

std::size_t KeyDetail::byte_count() const {
    return bisections.size() * sizeof(DetailBisection) + roots.size() * sizeof(Index) +
           errors.size() * sizeof(float) + levels.size() * sizeof(DetailLevel);
}

KeyDetail measure_detail(const Hierarchy& hierarchy, const DetailProgress& progress) {
    // The parts of the time that the stages take.
    constexpr double until_deviations = 0.45;
    constexpr double until_cones = 0.55;
    constexpr double until_errors = 0.8;
    const std::vector<float> deviation = deviations(hierarchy, detail_part(progress, 0, until_deviations));
    const BisectionForest forest = bisection_forest(hierarchy);
    const std::vector<NormalCone> cones = normal_cones(hierarchy, forest);
    KeyDetail detail;
    detail.errors =
        vertex_errors(hierarchy, forest, deviation, detail_part(progress, until_cones, until_errors));
    detail.levels = detail_levels(CutSizes(hierarchy, detail.errors));

    const std::vector<Index> order = order_by_error(forest, detail.errors);
    std::vector<Index> rank(order.size());
    for (Index n = 0; n < order.size(); ++n) rank[order[n]] = n;
    const auto rank_of = [&](Index place) { return place != no_index ? rank[place] : no_index; };
    detail.bisections.reserve(order.size());
    for (const Index place : order) {
        const Bisection& from = forest.bisections[place];
        const std::array<Index, 2>& both = forest.at[from.midpoint];
        detail.bisections.push_back({.midpoint = from.midpoint,
                                     .partner = rank_of(both[0] == place ? both[1] : both[0]),
                                     .needed = rank_of(forest.at[from.newest][0]),
                                     .children = {rank_of(from.children[0]), rank_of(from.children[1])},
                                     .deviation = deviation[place],
                                     .position = hierarchy.positions[from.midpoint],
                                     .axis = cones[place].axis,
                                     .sine = sine_of(cones[place])});
    }
    detail.roots.reserve(forest.roots.size());
    for (const Index place : forest.roots) detail.roots.push_back(rank_of(place));
    if (progress) progress(1);
    return detail;
}

}  // namespace interleaf
