#include "hierarchy/detail/cut.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include <doctest/doctest.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "hierarchy/checker.h"
#include "hierarchy/detail/deviation.h"
#include "hierarchy/detail/literal_detail.h"
#include "hierarchy/detail/vertex_errors.h"
#include "hierarchy/greedy.h"
#include "hierarchy/literal.h"
#include "hierarchy/marking.h"
#include "hierarchy/random_families.h"
#include "hierarchy/random_surfaces.h"

using namespace interleaf;
using namespace interleaf::testing;

namespace {

bool are_equal(const Hierarchy& a, const Hierarchy& b) {
    return a.roots == b.roots && a.bits == b.bits && a.midpoints == b.midpoints && a.positions == b.positions;
}

/// A threshold near the errors of a key: one of them, or a number between.
float random_threshold(const std::vector<float>& errors, Index root_vertices, Random& random) {
    if (errors.size() == root_vertices) return static_cast<float>(random.unit());
    const float error = errors[root_vertices + random.below(errors.size() - root_vertices)];
    return random.chance(0.3) ? error : error * static_cast<float>(2 * random.unit());
}

/// The largest distance of a point of \p from, sampled, from the surface \p to.
double sampled_distance(const Hierarchy& from, const Hierarchy& to) {
    constexpr int parts = 3;
    double farthest = 0;
    const std::vector<Leaf> targets = leaves_of(to);
    for (const Leaf& leaf : leaves_of(from))
        for (int i = 0; i <= parts; ++i)
            for (int j = 0; i + j <= parts; ++j) {
                const auto& [a, b, c] = leaf.vertices;
                const glm::dvec3 point =
                    (double(i) * glm::dvec3(from.positions[a]) + double(j) * glm::dvec3(from.positions[b]) +
                     double(parts - i - j) * glm::dvec3(from.positions[c])) /
                    double(parts);
                double nearest = std::numeric_limits<double>::infinity();
                for (const Leaf& target : targets) {
                    const auto& [d, e, f] = target.vertices;
                    nearest = std::min(
                        nearest, literal_distance(point, to.positions[d], to.positions[e], to.positions[f]));
                    if (nearest <= farthest) break;
                }
                farthest = std::max(farthest, nearest);
            }
    return farthest;
}

}  // namespace

TEST_CASE("every threshold cuts a sound sub-hierarchy, 3,000 hierarchies") {
    Random random(20260612);
    for_random_families(3000, 1, [&](const RandomFamily& family) {
        CAPTURE(family.seed);
        const Hierarchy& key = family.keys[0];
        const std::vector<float> errors = vertex_errors(key);
        const CutSizes sizes(key, errors);
        const float threshold = random_threshold(errors, key.roots.vertex_count(), random);
        CAPTURE(threshold);
        const Hierarchy coarse = cut(key, errors, threshold);
        REQUIRE(check(coarse) == std::vector<std::string>{});
        REQUIRE(std::ranges::includes(bisected_nodes(key), bisected_nodes(coarse)));
        REQUIRE(coarse.leaf_count() == sizes.leaf_count(threshold));
        REQUIRE(sizes.distance(threshold) <= threshold);
        // The largest error left out cuts the same.
        REQUIRE(are_equal(coarse, cut(key, errors, sizes.distance(threshold))));
        // A smaller threshold keeps all that a larger one keeps.
        const Hierarchy coarser = cut(key, errors, 1.5F * threshold);
        REQUIRE(std::ranges::includes(bisected_nodes(coarse), bisected_nodes(coarser)));
    });
}

TEST_CASE("no leaf of a cut deviates by more than the threshold") {
    Random random(20260613);
    for_random_families(1000, 1, [&](const RandomFamily& family) {
        CAPTURE(family.seed);
        const Hierarchy& key = family.keys[0];
        const std::vector<float> errors = vertex_errors(key);
        const std::vector<float> deviation = deviations(key);
        const float threshold = random_threshold(errors, key.roots.vertex_count(), random);
        std::set<Node> kept = bisected_nodes(cut(key, errors, threshold));
        std::size_t place = 0;
        // Nodes in preorder, with their deviations.
        const auto visit = [&](const auto& self, const Node& node, const std::set<Node>& all) -> void {
            if (!all.contains(node)) return;
            const float here = deviation[place++];
            const bool exists = node.level == 0 || kept.contains(node.parent());
            if (exists && !kept.contains(node)) REQUIRE(here <= threshold);
            self(self, node.child(0), all);
            self(self, node.child(1), all);
        };
        const std::set<Node> all = bisected_nodes(key);
        for (std::size_t root = 0; root < key.roots.triangle_count(); ++root) visit(visit, {root, 0, 0}, all);
        REQUIRE(place == deviation.size());
    });
}

TEST_CASE("the measured distance of a cut is at most the threshold, in both directions, random surfaces") {
    constexpr std::uint64_t seed = 20260614;
    CAPTURE(seed);
    Random random(seed);
    for (int n = 0; n < 5; ++n) {
        const RootComplex roots = random_surface(static_cast<unsigned>(n) % 3, n % 2 == 1, random);
        const Hierarchy key = bisected_key(roots, random);
        const std::vector<float> errors = vertex_errors(key);
        for (int m = 0; m < 4; ++m) {
            const float threshold = random_threshold(errors, roots.vertex_count(), random);
            const Hierarchy coarse = cut(key, errors, threshold);
            CHECK(sampled_distance(key, coarse) <= 1.000001 * static_cast<double>(threshold));
            CHECK(sampled_distance(coarse, key) <= 1.000001 * static_cast<double>(threshold));
        }
    }
}

TEST_CASE("the ends of all thresholds are the roots and the hierarchy itself") {
    for_random_families(500, 1, [](const RandomFamily& family) {
        CAPTURE(family.seed);
        const Hierarchy& key = family.keys[0];
        const std::vector<float> errors = vertex_errors(key);
        REQUIRE(are_equal(cut(key, errors, keep_everything), key));
        const std::vector<glm::vec3> root_positions(
            key.positions.begin(),
            key.positions.begin() + static_cast<std::ptrdiff_t>(key.roots.vertex_count()));
        REQUIRE(are_equal(cut(key, errors, std::numeric_limits<float>::infinity()),
                          unrefined(key.roots, root_positions)));
    });
}

TEST_CASE("a number of leaves is kept, and the next larger cut exceeds it") {
    for_random_families(1000, 1, [](const RandomFamily& family) {
        CAPTURE(family.seed);
        const Hierarchy& key = family.keys[0];
        const std::vector<float> errors = vertex_errors(key);
        const CutSizes sizes(key, errors);
        for (std::size_t limit = key.roots.triangle_count(); limit <= key.leaf_count() + 3; limit += 5) {
            const float threshold = sizes.threshold(limit);
            const std::size_t leaves = sizes.leaf_count(threshold);
            REQUIRE(leaves <= limit);
            if (threshold == keep_everything) {
                REQUIRE(leaves == key.leaf_count());
            } else {
                REQUIRE(sizes.leaf_count(std::nextafter(threshold, -1.0F)) > limit);
            }
        }
    });
}

TEST_CASE("the fields of a cut are those of the vertices that it keeps") {
    Random random(20260615);
    for_random_families(500, 1, [&](const RandomFamily& family) {
        CAPTURE(family.seed);
        Hierarchy key = family.keys[0];
        Field height{"height", FieldKind::scalar, {}}, color{"color", FieldKind::color, {}};
        for (const glm::vec3& p : key.positions) {
            height.values.push_back(p.z);
            for (int c = 0; c < 3; ++c) color.values.push_back(glm::clamp(0.5F + 0.2F * p[c], 0.0F, 1.0F));
        }
        key.fields = {height, color};
        const std::vector<float> errors = vertex_errors(key);
        const Hierarchy coarse = cut(key, errors, random_threshold(errors, key.roots.vertex_count(), random));
        REQUIRE(check(coarse).empty());
        REQUIRE(labels(coarse.fields) == labels(key.fields));
        for (Index v = 0; v < coarse.vertex_count(); ++v) {
            const glm::vec3 p = coarse.positions[v];
            REQUIRE(coarse.fields[0].at(v)[0] == p.z);
            REQUIRE(coarse.fields[1].at(v)[1] == glm::clamp(0.5F + 0.2F * p.y, 0.0F, 1.0F));
        }
    });
}

TEST_CASE("on the sphere a cut has about as many leaves as a greedy refinement of equal distance") {
    const std::vector<glm::vec3> corners = {{1, 0, 0},  {-1, 0, 0}, {0, 1, 0},
                                            {0, -1, 0}, {0, 0, 1},  {0, 0, -1}};
    for (const RootComplex& roots : {octahedron(), mark_compatibly(octahedron())}) {
        AdaptiveMesh* self = nullptr;
        const auto on_sphere = [&](Index a, Index b, Index) {
            return glm::normalize(self->positions()[a] + self->positions()[b]);
        };
        // The distance of the sphere from a leaf with corners on it.
        const auto distance = [](const AdaptiveMesh& mesh, Index leaf) {
            const auto& [a, b, c] = mesh.vertices(leaf);
            const auto p = mesh.positions();
            return 1 - literal_distance(glm::dvec3(0), p[a], p[b], p[c]);
        };
        const auto farthest = [](const Hierarchy& key) {
            double result = 0;
            for (const Leaf& leaf : leaves_of(key)) {
                const auto& [a, b, c] = leaf.vertices;
                result = std::max(result, 1 - literal_distance(glm::dvec3(0), key.positions[a],
                                                               key.positions[b], key.positions[c]));
            }
            return result;
        };
        AdaptiveMesh fine(roots, corners, on_sphere);
        self = &fine;
        refine_greedily(fine, distance, {.leaves = 40000});
        const Hierarchy key = fine.freeze();
        const std::vector<float> errors = vertex_errors(key);
        for (const float threshold : {0.1F, 0.05F, 0.02F, 0.01F, 0.005F, 0.002F}) {
            const Hierarchy coarse = cut(key, errors, threshold);
            const double reached = farthest(coarse);
            AdaptiveMesh greedy(roots, corners, on_sphere);
            self = &greedy;
            refine_greedily(greedy, distance, {.tolerance = reached * (1 + 1e-6)});
            MESSAGE("distance " << reached << ": cut " << coarse.leaf_count() << " leaves, greedy "
                                << greedy.leaf_count());
            CHECK(double(coarse.leaf_count()) <= 1.1 * double(greedy.leaf_count()));
        }
    }
}
