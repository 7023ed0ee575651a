#include "hierarchy/detail/view_mesh.h"

#include <algorithm>
#include <array>
#include <utility>

#include <doctest/doctest.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "hierarchy/checker.h"
#include "hierarchy/detail/random_views.h"
#include "hierarchy/morph.h"

using namespace interleaf;
using namespace interleaf::testing;

namespace {

using Vectors = Buffer<glm::vec3>;

/// Vectors at the vertices of \p view, as a function on the vertices of the union of \p keys.
Vectors on_union(const ViewMesh& view, std::span<const glm::vec3> vectors,
                 const std::vector<const Hierarchy*>& keys) {
    std::vector<Leaf> leaves;
    for (std::size_t n = 0; n < view.mesh.leaf_count(); ++n)
        leaves.push_back({view.mesh.triangles[n], static_cast<std::uint8_t>(view.mesh.tags[n].level())});
    const Hierarchy shown = hierarchy_from_leaves(view.mesh.roots, leaves, vectors);
    REQUIRE(check(shown).empty());
    std::vector<const Hierarchy*> all = {&shown};
    all.insert(all.end(), keys.begin(), keys.end());
    return unite(all).positions[0];
}

float farthest_of(const Vectors& a, const Vectors& b) {
    float result = 0;
    for (std::size_t v = 0; v < a.size(); ++v) result = std::max(result, glm::distance(a[v], b[v]));
    return result;
}

float length_of(const Vectors& a) {
    float result = 0;
    for (const glm::vec3& each : a) result = std::max(result, glm::length(each));
    return result;
}

/// A way from one view and blend to another.
struct Way {
    std::array<ViewPoint, 2> views;
    std::array<std::vector<float>, 2> weights;
    std::size_t budget;
};

/// The positions and the normals at \p part of \p way.
std::pair<Vectors, Vectors> seen_at(const Way& way, double part, const DetailedKeys& detailed,
                                    ViewRefinement& refinement) {
    std::vector<float> weights(way.weights[0].size());
    for (std::size_t key = 0; key < weights.size(); ++key)
        weights[key] = static_cast<float>((1 - part) * static_cast<double>(way.weights[0][key]) +
                                          part * static_cast<double>(way.weights[1][key]));
    const ViewPoint view = between(way.views[0], way.views[1], static_cast<float>(part));
    ViewMesh mesh;
    view_mesh(refinement.refine(weights, view, way.budget), detailed.keys, weights, mesh);
    return {on_union(mesh, mesh.positions, detailed.keys), on_union(mesh, mesh.normals, detailed.keys)};
}

}  // namespace

TEST_CASE("within the budget the view is the whole union and its blend") {
    for_random_details(200, 2, [](const RandomFamily&, Random& random, const DetailedKeys& detailed) {
        ViewRefinement refinement = detailed.refinement();
        const std::vector<float> weights = random_weights(random, 2);
        const UnionMesh whole = unite(detailed.keys);
        ViewMesh view;
        view_mesh(refinement.refine(weights, random_view(random), whole.leaf_count()), detailed.keys, weights,
                  view);
        REQUIRE(view.mesh.triangles == whole.triangles);
        REQUIRE(view.mesh.positions == whole.positions);
        REQUIRE(view.positions == morph(whole, weights));
    });
}

// A jump would remain however short the step is. So the test halves the way again and again where the surface
// moves most, and the movement must vanish.
TEST_CASE("the surface and its normals move continuously with view and weights") {
    for_random_details(300, 3, [](const RandomFamily& family, Random& random, const DetailedKeys& detailed) {
        ViewRefinement refinement = detailed.refinement();
        const Way way{.views = {random_view(random), random_view(random)},
                      .weights = {random_weights(random, 3), random_weights(random, 3)},
                      .budget = family.roots.triangle_count() + 20 + random.below(60)};
        for (const bool normals : {false, true}) {
            const auto at = [&](double part) {
                auto [positions, directions] = seen_at(way, part, detailed, refinement);
                return normals ? std::move(directions) : std::move(positions);
            };
            double begin = 0, step = 1;
            float movement = 0;
            for (int round = 0; round < 6; ++round) {
                constexpr int parts = 8;
                step /= parts;
                double next = begin;
                movement = 0;
                Vectors before = at(begin);
                for (int n = 1; n <= parts; ++n) {
                    Vectors now = at(begin + step * n);
                    if (const float moved = farthest_of(before, now); moved > movement) {
                        movement = moved;
                        next = begin + step * (n - 1);
                    }
                    before = std::move(now);
                }
                begin = next;
            }
            CAPTURE(normals);
            REQUIRE(movement < 2e-3F * length_of(at(begin)));
        }
    });
}

TEST_CASE("a field that is a coordinate remains that coordinate") {
    for_random_families(150, 2, [](const RandomFamily& family) {
        CAPTURE(family.seed);
        Random random(family.seed);
        std::vector<Hierarchy> keys = family.keys;
        for (Hierarchy& key : keys) {
            Field field{.name = "x", .values = {}};
            for (const glm::vec3& position : key.positions) field.values.push_back(position.x);
            key.fields.push_back(field);
        }
        const DetailedKeys detailed(keys);
        ViewRefinement refinement = detailed.refinement();
        const std::vector<float> weights = random_weights(random, 2);
        ViewMesh view;
        view_mesh(refinement.refine(weights, random_view(random), family.roots.triangle_count() + 30),
                  detailed.keys, weights, view);
        const UnionField field = view_field(view, detailed.keys, weights, keys[0].fields[0].label());
        for (std::size_t v = 0; v < view.positions.size(); ++v)
            REQUIRE(field.values[0][v] == doctest::Approx(view.positions[v].x).epsilon(1e-5));
    });
}
