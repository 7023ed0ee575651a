#include "comparison.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>
#include <set>

#include "closed_again.h"
#include "special_cases.h"
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "hierarchy/measure.h"
#include "hierarchy/union_mesh.h"
#include "shapes/icosahedron.h"
#include "shapes/leaf_fit.h"

namespace interleaf::bench {
namespace {

using Json = nlohmann::ordered_json;

/// As in make_key(): between the samples, the distance to the surface may exceed the one at the samples by
/// this fraction.
constexpr double sampling_margin = 0.1;

/// As in make_key(): the diagonal of the surface's box, from samples.
double box_diagonal(Surface surface) {
    constexpr unsigned divisions = 24;
    const Hierarchy roots = icosahedron();
    glm::dvec3 low(std::numeric_limits<double>::infinity());
    glm::dvec3 high = -low;
    for (const auto& [a, b, c] : roots.roots.triangles()) {
        for (const glm::dvec3& u : base_grid(
                 unit_sphere, {roots.positions[a], roots.positions[b], roots.positions[c]}, divisions)) {
            low = glm::min(low, surface(u));
            high = glm::max(high, surface(u));
        }
    }
    return glm::distance(low, high);
}

double min_tolerance(std::size_t max_leaves, const std::function<std::size_t(double)>& leaves) {
    double too_small = 1e-5;
    double enough = 0.1;
    while (enough > too_small * 1.001) {
        const double middle = std::sqrt(too_small * enough);
        (leaves(middle) <= max_leaves ? enough : too_small) = middle;
    }
    return enough;
}

double area(std::span<const Triangle> triangles, const std::function<glm::dvec3(Index)>& position) {
    double sum = 0;
    for (const auto& [i, j, k] : triangles) {
        const glm::dvec3 corner = position(i);
        sum += glm::length(glm::cross(position(j) - corner, position(k) - corner)) / 2;
    }
    return sum;
}

std::size_t total(std::span<const std::size_t> counts) {
    return std::accumulate(counts.begin(), counts.end(), std::size_t{0});
}

/// The relative difference between the area of a union with the positions of \p key, its key at \p place, and
/// the key's own area.
double area_difference(const UnionMesh& mesh, std::size_t place, const Hierarchy& key) {
    std::vector<Triangle> leaves;
    leaves.reserve(key.leaf_count());
    for (const Leaf& leaf : leaves_of(key)) leaves.push_back(leaf.vertices);
    const double own = area(leaves, [&](Index vertex) { return glm::dvec3(key.positions[vertex]); });
    const double here =
        area(mesh.triangles, [&](Index vertex) { return glm::dvec3(mesh.positions[place][vertex]); });
    return std::abs(here / own - 1);
}

/// Checks what the documentation claims: the overlay is a closed manifold and has each key's area.
Json checks(const Overlay& overlay, std::span<const Triangle> triangles, std::span<const RedGreenKey> keys) {
    double largest = 0;
    for (std::size_t key = 0; key < keys.size(); ++key) {
        const double own =
            area(mesh_of(keys[key].forest), [&](Index vertex) { return keys[key].position(vertex); });
        const double here = area(triangles, [&](Index vertex) { return overlay.positions[key][vertex]; });
        largest = std::max(largest, std::abs(here / own - 1));
    }
    return {{"closed_manifold", is_closed_manifold(triangles)},
            {"euler_number", euler_number(triangles)},
            {"largest_difference_of_area_from_a_key", largest}};
}

Json overlay_figures(const Overlay& result, std::span<const RedGreenKey> keys) {
    const SpecialCases cases = special_cases(result, keys);
    const std::vector<Triangle> triangles = triangles_of(result);
    Json pairs = Json::array();
    for (const GreenPairs& each : cases.green_pairs)
        pairs.push_back({{"all", each.count()},
                         {"kept", each.kept},
                         {"split_red_by_another_key", each.split_red},
                         {"crossed_by_another_line", each.crossed}});
    return {{"leaves", triangles.size()},
            {"vertices", result.vertex_count()},
            {"vertices_of_no_key", result.vertices_of_no_key},
            {"red_leaves", result.leaves.size()},
            {"plain", cases.leaves[0]},
            {"halved_by_own_green_line", cases.leaves[1]},
            {"halved_by_line_of_larger_leaf", cases.leaves[2]},
            {"two_lines_cross", cases.leaves[3]},
            {"three_lines_cross", cases.leaves[4]},
            {"special_cases", cases.conflicts()},
            {"configurations", cases.configurations},
            {"possible_configurations", cases.possible_configurations},
            {"means_that_fail", cases.means_that_fail},
            {"green_pairs", pairs},
            {"checks", checks(result, triangles, keys)}};
}

}  // namespace

RedComplex sphere_complex() {
    const Hierarchy roots = icosahedron();
    std::vector<glm::dvec3> points;
    for (const glm::dvec3 corner : roots.positions) points.push_back(glm::normalize(corner));
    return {roots.roots, points,
            [](const glm::dvec3& a, const glm::dvec3& b) { return glm::normalize(a + b); }};
}

Subject::Subject(RedComplex& complex, std::string_view shape)
    : complex_(&complex),
      shape_(find_shape(shape)),
      diagonal_(box_diagonal(shape_->surface)),
      errors_(complex, shape_->surface) {}

RedGreenKey Subject::red_green(double tolerance) {
    return refined_to(tolerance * diagonal_ * (1 - sampling_margin), *complex_, shape_->surface, errors_);
}

Hierarchy Subject::bisected(double tolerance) const {
    return make_key(*shape_, {{}, tolerance});
}

double Subject::red_green_tolerance(std::size_t leaves) {
    return min_tolerance(leaves,
                         [&](double tolerance) { return mesh_of(red_green(tolerance).forest).size(); });
}

double Subject::bisection_tolerance(std::size_t leaves) const {
    return min_tolerance(leaves, [&](double tolerance) { return bisected(tolerance).leaf_count(); });
}

std::vector<RedGreenKey> red_green_keys(std::span<Subject* const> subjects,
                                        std::span<const double> tolerances) {
    std::vector<RedGreenKey> keys;
    keys.reserve(subjects.size());
    for (std::size_t i = 0; i < subjects.size(); ++i) keys.push_back(subjects[i]->red_green(tolerances[i]));
    return keys;
}

std::vector<Hierarchy> bisected_keys(std::span<Subject* const> subjects, std::span<const double> tolerances) {
    std::vector<Hierarchy> keys;
    keys.reserve(subjects.size());
    for (std::size_t i = 0; i < subjects.size(); ++i) keys.push_back(subjects[i]->bisected(tolerances[i]));
    return keys;
}

Json red_green_figures(std::span<Subject* const> subjects, std::span<const double> tolerances) {
    const std::vector<RedGreenKey> keys = red_green_keys(subjects, tolerances);
    std::vector<std::size_t> leaves;
    leaves.reserve(keys.size());
    for (const RedGreenKey& key : keys) leaves.push_back(mesh_of(key.forest).size());
    const ClosedAgain closed = closed_again(keys);
    Json losses = Json::array();
    for (std::size_t i = 0; i < keys.size(); ++i)
        losses.push_back(closed.max_loss[i] / subjects[i]->diagonal());
    return {{"tolerances", tolerances},
            {"key_leaves", leaves},
            {"sum_of_key_leaves", total(leaves)},
            {"overlay", overlay_figures(overlay(keys), keys)},
            {"closed_again",
             {{"leaves", closed.triangles},
              {"red_splits_of_no_key", closed.added_splits},
              {"red_leaves_where_a_key_is_lost", closed.leaves_with_loss},
              {"largest_distance_from_key", losses}}}};
}

Json bisection_figures(std::span<Subject* const> subjects, std::span<const double> tolerances) {
    const std::vector<Hierarchy> keys = bisected_keys(subjects, tolerances);
    std::vector<const Hierarchy*> pointers;
    std::vector<std::size_t> leaves;
    for (const Hierarchy& key : keys) {
        pointers.push_back(&key);
        leaves.push_back(key.leaf_count());
    }
    const UnionMesh mesh = unite(pointers);
    std::set<int> own_keys;
    for (const KeySet origin : mesh.origins) own_keys.insert(std::popcount(origin));
    double max_difference = 0;
    for (std::size_t i = 0; i < keys.size(); ++i)
        max_difference = std::max(max_difference, area_difference(mesh, i, keys[i]));
    const auto of_no_key = std::count_if(
        mesh.vertices.begin(), mesh.vertices.end(),
        [](const VertexOrigin& vertex) { return vertex.edge[0] != no_index && vertex.keys == 0; });
    return {{"tolerances", tolerances},
            {"key_leaves", leaves},
            {"sum_of_key_leaves", total(leaves)},
            {"union_leaves", mesh.leaf_count()},
            {"union_vertices", mesh.vertex_count()},
            {"vertices_of_no_key", of_no_key},
            {"special_cases", 0},  // theorem 2
            {"configurations", own_keys.size()},
            {"checks",
             {{"closed_manifold", is_closed_manifold(mesh.triangles)},
              {"euler_number", euler_number(mesh.triangles)},
              {"largest_difference_of_area_from_a_key", max_difference}}}};
}

}  // namespace interleaf::bench
