#include "hierarchy/detail/view_refinement.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "hierarchy/checker.h"
#include "hierarchy/detail/bisected_nodes.h"
#include "hierarchy/detail/bisection_forest.h"
#include "hierarchy/detail/cut.h"
#include "hierarchy/detail/deviation.h"
#include "hierarchy/detail/literal_detail.h"
#include "hierarchy/detail/normal_cones.h"
#include "hierarchy/detail/random_views.h"
#include "hierarchy/detail/view_mesh.h"
#include "hierarchy/measure.h"
#include "hierarchy/union_mesh.h"

using namespace interleaf;
using namespace interleaf::testing;

namespace {

/// The cut of key \p number that \p view contains, made from nothing but its vertices.
Hierarchy cut_in(const RefinedView& view, const std::vector<const Hierarchy*>& keys, std::size_t number) {
    std::vector<float> is_made(keys[number]->vertex_count(), 0.0F);
    for (std::size_t v = 0; v < view.vertices.size(); ++v)
        if (const Index own = view.own[v * keys.size() + number]; own != no_index) is_made[own] = 1;
    return cut(*keys[number], is_made, 0.5F);
}

/// The view error of each bisection of a single key, literally.
std::vector<float> literal_view_errors(const Hierarchy& key, const ViewPoint& view) {
    const bool is_closed = is_closed_manifold(key.roots.triangles());
    const std::vector<float> deviation = deviations(key);
    const std::vector<NormalCone> cones = normal_cones(key, bisection_forest(key));
    std::vector<float> errors;
    for_each_bisected_node(key, [&](const BisectedNode& node) {
        std::array<glm::vec3, 3> p;
        for (std::size_t c = 0; c < 3; ++c) p[c] = key.positions[node.vertices[c]];
        Ball ball{(p[0] + p[1] + p[2]) / 3.0F, 0};
        for (const glm::vec3& corner : p)
            ball.radius = std::max(ball.radius, glm::distance(corner, ball.center));
        ball.radius += deviation[node.place];
        const NormalCone& cone = cones[node.place];
        const float sine = cone.half_angle < std::numbers::pi_v<float> / 2 ? std::sin(cone.half_angle) : 2;
        const SeenBall seen(view, ball);
        errors.push_back(
            (deviation[node.place] * seen.prominence(cone.axis, sine, is_closed) + ball.radius / 4096) *
            seen.magnification());
    });
    return errors;
}

}  // namespace

TEST_CASE("each key's cut for a view passes the checker, their union is the view's, within the budget") {
    for_random_details(1500, 3, [](const RandomFamily& family, Random& random, const DetailedKeys& detailed) {
        ViewRefinement refinement = detailed.refinement();
        ViewMesh mesh;
        for (int n = 0; n < 3; ++n) {
            const std::vector<float> weights = random_weights(random, family.keys.size());
            const std::size_t roots = family.roots.triangle_count();
            const std::size_t budget = roots + random.below(100);
            const RefinedView& view = refinement.refine(weights, random_view(random), budget);
            REQUIRE(view.leaf_count <= budget);
            REQUIRE(view.nodes.size() == 2 * view.leaf_count - roots);
            std::vector<Hierarchy> cuts;
            cuts.reserve(family.keys.size());
            for (std::size_t key = 0; key < family.keys.size(); ++key) {
                cuts.push_back(cut_in(view, detailed.keys, key));
                REQUIRE(check(cuts.back()).empty());
            }
            std::vector<const Hierarchy*> pointers;
            pointers.reserve(cuts.size());
            for (const Hierarchy& each : cuts) pointers.push_back(&each);
            const UnionMesh expected = unite(pointers);
            view_mesh(view, detailed.keys, weights, mesh);
            REQUIRE(mesh.mesh.triangles == expected.triangles);
            REQUIRE(mesh.mesh.origins == expected.origins);
            REQUIRE(
                std::ranges::equal(mesh.mesh.tags, expected.tags, {}, &LeafTag::packed, &LeafTag::packed));
        }
    });
}

TEST_CASE("errors in a view are those of the literal greedy refinement") {
    for_random_details(1500, 1, [](const RandomFamily& family, Random& random, const DetailedKeys& detailed) {
        const ViewPoint at = random_view(random);
        const std::vector<float> expected =
            literal_errors(family.keys[0], literal_view_errors(family.keys[0], at));
        ViewRefinement refinement = detailed.refinement();
        const RefinedView& view =
            refinement.refine(std::array{1.0F}, at, 1 + family.keys[0].leaf_count() / 2);
        for (std::size_t v = family.roots.vertex_count(); v < view.vertices.size(); ++v)
            REQUIRE(view.vertices[v].error == doctest::Approx(expected[view.own[v]]).epsilon(1e-4));
        for (std::size_t v = 0; v < expected.size(); ++v)
            if (expected[v] > view.threshold * 1.0001F) REQUIRE(std::ranges::count(view.own, v) == 1);
    });
}

TEST_CASE("a refinement leaves nothing behind for the next view") {
    for_random_details(200, 2, [](const RandomFamily& family, Random& random, const DetailedKeys& detailed) {
        ViewRefinement used = detailed.refinement(), fresh = detailed.refinement();
        const std::vector<float> weights = random_weights(random, 2);
        const std::size_t budget = family.roots.triangle_count() + 40;
        used.refine(weights, random_view(random), budget);
        const ViewPoint at = random_view(random);
        const RefinedView& a = used.refine(weights, at, budget);
        const RefinedView& b = fresh.refine(weights, at, budget);
        REQUIRE(a.own == b.own);
        REQUIRE(a.places == b.places);
        REQUIRE(a.threshold == b.threshold);
    });
}

TEST_CASE("what is near, in the picture or at a silhouette matters more") {
    const ViewPoint view{.eye = {0, 0, 5}, .forward = {0, 0, -1}, .cosine = 0.92F};
    const auto larger = [&](glm::vec3 center) { return SeenBall(view, {center, 0.1F}).magnification(); };
    CHECK(larger({0, 0, 3}) > 1.5F * larger({0, 0, 0}));
    CHECK(larger({5, 0, 5}) < 0.1F * larger({0, 0, 0}));
    const SeenBall ball(view, {{0, 0, 0}, 0.01F});
    const auto seen = [&](glm::vec3 normal, bool is_closed) {
        return ball.prominence(glm::normalize(normal), 0.05F, is_closed);
    };
    CHECK(seen({1, 0, 0}, true) == 1);
    CHECK(seen({0, 0, 1}, true) < 0.3F);
    CHECK(seen({0, 0, -1}, true) < 0.1F);
    CHECK(seen({0, 0, -1}, false) == doctest::Approx(seen({0, 0, 1}, false)).epsilon(0.01));
    CHECK(seen({1, 0, 1}, true) > seen({1, 0, 2}, true));
    CHECK(ball.prominence({}, 2, true) == 1);
}

TEST_CASE("a cone around two cones holds both") {
    Random random(7);
    for (int n = 0; n < 1000; ++n) {
        const auto cone = [&] {
            return NormalCone{glm::normalize(random.point() + glm::vec3(1e-3F)),
                              static_cast<float>(random.unit())};
        };
        const NormalCone a = cone(), b = cone();
        const NormalCone both = cone_around(a, b);
        for (const NormalCone& each : {a, b})
            CHECK(std::acos(std::clamp(glm::dot(each.axis, both.axis), -1.0F, 1.0F)) + each.half_angle <=
                  both.half_angle + 1e-3F);
    }
}
