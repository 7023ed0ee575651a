#include "hierarchy/detail/vertex_errors.h"

#include <algorithm>
#include <cmath>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "hierarchy/detail/bisected_nodes.h"
#include "hierarchy/detail/deviation.h"
#include "hierarchy/detail/literal_detail.h"
#include "hierarchy/random_families.h"

using namespace interleaf;
using namespace interleaf::testing;

TEST_CASE("deviations are the literal ones, 800 hierarchies") {
    for_random_families(800, 1, [](const RandomFamily& family) {
        CAPTURE(family.seed);
        const std::vector<float> found = deviations(family.keys[0]);
        const std::vector<double> expected = literal_deviations(family.keys[0]);
        REQUIRE(found.size() == expected.size());
        for (std::size_t n = 0; n < found.size(); ++n)
            REQUIRE(static_cast<double>(found[n]) == doctest::Approx(expected[n]).epsilon(1e-6));
    });
}

TEST_CASE("a triangle without area deviates by the distance from its longest edge") {
    // All corners lie on one line.
    const RootComplex roots(3, {{0, 1, 2}});
    AdaptiveMesh mesh(roots, std::vector<glm::vec3>{{1, 0, 0}, {0, 0, 0}, {3, 0, 0}},
                      [](Index, Index, Index) { return glm::vec3(1, 2, 0); });
    mesh.refine(std::vector<Index>{0});
    CHECK(deviations(mesh.freeze()) == std::vector<float>{2});
    // All corners lie at one point.
    AdaptiveMesh point(roots, std::vector<glm::vec3>(3, glm::vec3(0)),
                       [](Index, Index, Index) { return glm::vec3(0, 3, 4); });
    point.refine(std::vector<Index>{0});
    CHECK(deviations(point.freeze()) == std::vector<float>{5});
}

TEST_CASE("errors are those of the literal greedy refinement, 600 hierarchies") {
    for_random_families(600, 1, [](const RandomFamily& family) {
        CAPTURE(family.seed);
        REQUIRE(vertex_errors(family.keys[0]) == literal_errors(family.keys[0], deviations(family.keys[0])));
    });
}

TEST_CASE("no vertex has a larger error than the newest vertex of a triangle that it bisects") {
    for_random_families(2000, 1, [](const RandomFamily& family) {
        CAPTURE(family.seed);
        const Hierarchy& key = family.keys[0];
        const std::vector<float> errors = vertex_errors(key);
        for_each_bisected_node(key, [&](const BisectedNode& node) {
            REQUIRE(errors[node.midpoint] <= errors[node.vertices[0]]);
        });
    });
}

TEST_CASE("vertices that depend on each other in a cycle share one error") {
    Random random(20260611);
    for (Index spokes = 3; spokes < 9; ++spokes) {
        CAPTURE(spokes);
        const RootComplex roots = pinwheel(spokes);
        AdaptiveMesh* self = nullptr;
        AdaptiveMesh mesh(roots, random_points(random, roots.vertex_count()), [&](Index a, Index b, Index) {
            return 0.5F * (self->positions()[a] + self->positions()[b]) + 0.2F * random.point();
        });
        self = &mesh;
        mesh.refine(std::vector<Index>{0});
        const Hierarchy key = mesh.freeze();
        const std::vector<float> errors = vertex_errors(key);
        const std::vector<float> all = deviations(key);
        std::size_t made = 0;
        for (Index v = roots.vertex_count(); v < key.vertex_count(); ++v, ++made)
            CHECK(errors[v] == errors[roots.vertex_count()]);
        CHECK(made == spokes);
        CHECK(errors[roots.vertex_count()] <= *std::ranges::max_element(all));
    }
}

TEST_CASE("a hierarchy without bisections has no errors but infinity") {
    const RootComplex roots(3, {{0, 1, 2}});
    const std::vector<float> errors = vertex_errors(unrefined(roots, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
    REQUIRE(errors.size() == 3);
    for (const float error : errors) CHECK(std::isinf(error));
}
