#include "sequence/series/ordered_series.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

#include <glm/geometric.hpp>

#include "hierarchy/error.h"
#include "hierarchy/matching/synchronize.h"
#include "sequence/series/step_key.h"

namespace interleaf {

namespace {

/// The roots of a step in their own numbering.
struct StepRoots {
    OrderedRoots placed;
    std::vector<Index> vertices;  ///< of the step, per root vertex
};

/// \return none if \p triangles are no root complex
std::optional<StepRoots> number_roots(const StepMesh& step, std::vector<Triangle> triangles) {
    std::vector<Index> number(step.points.size(), no_index);
    StepRoots roots;
    for (Triangle& triangle : triangles)
        for (Index& vertex : triangle) {
            if (number[vertex] == no_index) {
                number[vertex] = static_cast<Index>(roots.vertices.size());
                roots.vertices.push_back(vertex);
            }
            vertex = number[vertex];
        }
    for (const Index vertex : roots.vertices) roots.placed.positions.emplace_back(step.points[vertex]);
    try {
        roots.placed.complex = RootComplex(static_cast<Index>(roots.vertices.size()), std::move(triangles));
    } catch (const InputError&) {
        return std::nullopt;
    }
    return roots;
}

/// The sum of squared distances of the vertices from their counterparts.
double distance_of(const OrderedRoots& roots, const OrderedRoots& other, const RootMatch& match) {
    double sum = 0;
    for (std::size_t v = 0; v < match.vertices.size(); ++v) {
        const glm::dvec3 apart =
            glm::dvec3(roots.positions[v]) - glm::dvec3(other.positions[match.vertices[v]]);
        sum += glm::dot(apart, apart);
    }
    return sum;
}

std::optional<RootMatch> match_with(const OrderedRoots& roots, const OrderedRoots& other,
                                    std::span<const Index> given) {
    RootMatchOptions options;
    options.given = given;
    auto match = match_roots({roots.complex, roots.positions}, {other.complex, other.positions}, options);
    if (auto* found = std::get_if<RootMatch>(&match)) return std::move(*found);
    return std::nullopt;
}

/// Which root of \p other is which of \p roots. Roots in the same order are the same, unless other ones have
/// stood still.
std::optional<RootMatch> match_steps(const OrderedRoots& roots, const OrderedRoots& other) {
    if (roots.complex.triangle_count() != other.complex.triangle_count() ||
        roots.complex.vertex_count() != other.complex.vertex_count())
        return std::nullopt;
    std::vector<Index> same_order(roots.complex.triangle_count());
    std::iota(same_order.begin(), same_order.end(), Index{0});
    std::optional<RootMatch> in_order = match_with(roots, other, same_order);
    if (in_order && distance_of(roots, other, *in_order) == 0) return in_order;
    std::optional<RootMatch> nearest = match_with(roots, other, {});
    if (!in_order || !nearest) return in_order ? in_order : nearest;
    constexpr double still = 1e-6;  // relative to the squared distances in order
    const bool stood_still =
        distance_of(roots, other, *nearest) < still * distance_of(roots, other, *in_order);
    return stood_still ? nearest : in_order;
}

/// The positions of \p other in the order of the roots that \p match maps to it.
std::vector<glm::vec3> matched_positions(const OrderedRoots& other, const RootMatch& match) {
    std::vector<glm::vec3> positions;
    positions.reserve(match.vertices.size());
    for (const Index vertex : match.vertices) positions.push_back(other.positions[vertex]);
    return positions;
}

}  // namespace

OrderSearch::OrderSearch(std::optional<unsigned> newest)
    : least_triangles_(std::numeric_limits<std::size_t>::max()) {
    for (unsigned corner = 0; corner < 3; ++corner)
        for (const bool lowest_is_second : {false, true})
            if (!newest || *newest == corner) candidates_.push_back({{corner, lowest_is_second}, {}, 0});
}

bool OrderSearch::fits(Candidate& candidate, const StepMesh& step) const {
    std::optional<OrderedForest> forest = coarsen_by_order(step, candidate.rule, least_triangles_ / 2);
    if (!forest) return false;
    std::optional<StepRoots> found = number_roots(step, std::move(forest->roots));
    if (!found) return false;
    candidate.deviation += forest->deviation;
    if (is_first_) {
        candidate.roots = std::move(found->placed);
        return true;
    }
    const std::optional<RootMatch> match = match_steps(candidate.roots, found->placed);
    if (match) candidate.roots.positions = matched_positions(found->placed, *match);
    return match && candidate.roots.complex.triangle_count() <= least_triangles_ / 2;
}

bool OrderSearch::add(const StepMesh& step) {
    least_triangles_ = std::min(least_triangles_, step.triangles.size());
    std::erase_if(candidates_, [&](Candidate& candidate) { return !fits(candidate, step); });
    is_first_ = false;
    return !candidates_.empty();
}

std::optional<OrderRule> OrderSearch::best() const {
    const auto best = std::ranges::min_element(candidates_, {}, [](const Candidate& candidate) {
        return std::pair(candidate.roots.complex.triangle_count(), candidate.deviation);
    });
    return best == candidates_.end() ? std::nullopt : std::optional(best->rule);
}

std::optional<Hierarchy> key_by_order(const StepMesh& step, const OrderRule& rule, const SeriesFields& fields,
                                      OrderedRoots& roots) {
    std::optional<OrderedForest> forest = coarsen_by_order(step, rule, step.triangles.size());
    if (!forest) return std::nullopt;
    std::optional<StepRoots> found = number_roots(step, std::move(forest->roots));
    if (!found) return std::nullopt;
    Hierarchy key =
        key_of_step(step, found->placed.complex, found->vertices, std::move(forest->leaves), fields);
    if (roots.positions.empty()) {
        roots = std::move(found->placed);
        return key;
    }
    const std::optional<RootMatch> match = match_steps(roots, found->placed);
    if (!match) return std::nullopt;
    roots.positions = matched_positions(found->placed, *match);
    return with_roots_of(roots.complex, key, *match);
}

}  // namespace interleaf
