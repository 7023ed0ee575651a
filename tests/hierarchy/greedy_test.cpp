#include "hierarchy/greedy.h"

#include <algorithm>
#include <map>
#include <utility>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "hierarchy/checker.h"
#include "hierarchy/marking.h"
#include "hierarchy/random_families.h"

using namespace interleaf;
using namespace interleaf::testing;

namespace {

std::vector<glm::vec3> octahedron_points() {
    return {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
}

}  // namespace

TEST_CASE(
    "a budget of leaves is never exceeded, and reached to within one bisection under a compatible marking of "
    "a "
    "closed surface") {
    for (Index budget = 8; budget < 400; budget += 7) {
        CAPTURE(budget);
        AdaptiveMesh mesh(octahedron(), octahedron_points());
        refine_greedily(mesh, longest_edge, {.leaves = budget});
        CHECK(mesh.leaf_count() <= budget);
        CHECK(check(mesh.freeze()).empty());
        AdaptiveMesh compatible(mark_compatibly(octahedron()), octahedron_points());
        refine_greedily(compatible, longest_edge, {.leaves = budget});
        CHECK(compatible.leaf_count() <= budget);
        CHECK(compatible.leaf_count() + 2 > budget);
    }
}

TEST_CASE("a tolerance holds for every leaf, and fails for a mesh with far fewer leaves") {
    AdaptiveMesh mesh(octahedron(), octahedron_points());
    refine_greedily(mesh, longest_edge, {.tolerance = 0.1});
    for (Index leaf = 0; leaf < mesh.leaf_count(); ++leaf) REQUIRE(longest_edge(mesh, leaf) <= 0.1);
    AdaptiveMesh fewer(octahedron(), octahedron_points());
    refine_greedily(fewer, longest_edge, {.leaves = mesh.leaf_count() / 4});
    bool holds = true;
    for (Index leaf = 0; leaf < fewer.leaf_count(); ++leaf) holds = holds && longest_edge(fewer, leaf) <= 0.1;
    CHECK_FALSE(holds);
}

TEST_CASE("leaves go where the error is") {
    AdaptiveMesh mesh(octahedron(), octahedron_points());
    const glm::vec3 place(1, 0, 0);
    const auto distance = [&](Index leaf) {
        return glm::distance(mesh.positions()[mesh.vertices(leaf)[0]], place);
    };
    refine_greedily(
        mesh,
        [&](const AdaptiveMesh& m, Index leaf) { return longest_edge(m, leaf) / (0.01 + distance(leaf)); },
        {.leaves = 500});
    std::size_t near = 0;
    for (Index leaf = 0; leaf < mesh.leaf_count(); ++leaf) near += distance(leaf) < 0.5F ? 1 : 0;
    CHECK(near > mesh.leaf_count() / 2);
}

TEST_CASE("replaying the changes reported after each step gives the same leaves") {
    // Also under a marking of the octahedron in which leaves wait for each other in cycles.
    for (const RootComplex& roots : {octahedron(), mark_compatibly(octahedron())}) {
        std::map<std::pair<Index, Index>, Index> midpoint;
        const auto points = octahedron_points();
        AdaptiveMesh mesh(roots, points, [&](Index a, Index b, Index made) {
            midpoint[{a, b}] = made;
            return glm::normalize(mesh.positions()[a] + mesh.positions()[b]);
        });
        std::vector<Triangle> leaves(roots.triangles().begin(), roots.triangles().end());
        const auto replay = [&](const AdaptiveMesh&, std::span<const Index> changed) {
            REQUIRE(changed.size() % 2 == 0);
            for (std::size_t i = 0; i < changed.size(); i += 2) {
                const Triangle parent = leaves[changed[i]];
                const auto [a, b] = std::minmax(parent[1], parent[2]);
                const auto children = bisect(parent, midpoint.at({a, b}));
                leaves.resize(std::max<std::size_t>(leaves.size(), changed[i + 1] + 1));
                leaves[changed[i]] = children[0];
                leaves[changed[i + 1]] = children[1];
            }
        };
        refine_greedily(mesh, longest_edge, {.leaves = 3000, .after_step = replay});
        REQUIRE(leaves.size() == mesh.leaf_count());
        for (Index leaf = 0; leaf < mesh.leaf_count(); ++leaf) CHECK(leaves[leaf] == mesh.vertices(leaf));
    }
}
