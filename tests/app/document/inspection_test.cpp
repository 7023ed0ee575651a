// Tests of the facts about the inspected node.
#include "app/document/inspection.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "hierarchy/morph.h"
#include "hierarchy/random_families.h"

using namespace interleaf;
using namespace interleaf::testing;

namespace {

/// Three keys over the same roots, with a timeline from the first to the second and to the third.
Family family_of(const RandomFamily& random) {
    Family family;
    family.name = "random";
    std::vector<TimelineKey> times;
    for (std::size_t key = 0; key < random.keys.size(); ++key) {
        family.keys.push_back(
            {std::string(1, static_cast<char>('a' + key)), SharedHierarchy(random.keys[key])});
        times.push_back({static_cast<double>(key), key});
    }
    family.timeline.emplace(std::move(times));
    return family;
}

}  // namespace

TEST_CASE("the inspector shows in each active key what the union says about the same leaf") {
    for (std::uint64_t seed = 0; seed < 40; ++seed) {
        CAPTURE(seed);
        const RandomFamily random = random_family(seed, 3);
        ViewerState state(family_of(random));
        state.session.seek(0.25, 0);
        const std::array<const Hierarchy*, 2> active = {&random.keys[0], &random.keys[1]};
        const UnionMesh mesh = unite(active);
        const NodeIndex index(mesh);
        const auto blend = morph(mesh, std::array{0.75F, 0.25F});
        Inspection inspection;
        inspection.follow(state);
        CHECK(inspection.shown() == nullptr);
        for (Index root = 0; root < random.roots.triangle_count(); ++root) {
            NodePath node{root, 0, 0};
            while (index.state(node) == NodeState::bisected) node = child_of(node, seed % 2 == 0 ? 0 : 1);
            state.inspected = node;
            inspection.follow(state);
            REQUIRE(inspection.shown() != nullptr);
            const InspectedNode& shown = *inspection.shown();
            CHECK(shown.state == NodeState::leaf);
            REQUIRE(shown.keys.size() == 2);
            const std::size_t leaf = index.leaves(node).begin;
            for (std::size_t key = 0; key < 2; ++key) {
                CHECK(shown.keys[key].name == (key == 0 ? "a" : "b"));
                CHECK((shown.keys[key].state == NodeState::inside_leaf) ==
                      ((mesh.origins[leaf] & key_bit(key)) == 0));
                for (std::size_t corner = 0; corner < 3; ++corner) {
                    const Index vertex = mesh.triangles[leaf][corner];
                    CHECK(glm::distance(shown.keys[key].corners[corner], mesh.positions[key][vertex]) <
                          1e-5F);
                    CHECK(glm::distance(shown.blend[corner], blend[vertex]) < 1e-5F);
                    CHECK((shown.keys[key].vertices[corner] != no_index) ==
                          ((mesh.vertices[vertex].keys & key_bit(key)) != 0));
                }
            }
        }
    }
}

TEST_CASE("where parts turn, the inspector has the corners of the surface, and keeps them while it is late") {
    const RandomFamily random = random_family(3, 3);
    Family family = family_of(random);
    family.blend = BlendKind::turning;
    ViewerState state(std::move(family));
    state.session.seek(0.25, 0);
    state.inspected = NodePath{};
    const std::array<glm::vec3, 3> turned = {glm::vec3(1, 2, 3), glm::vec3(4, 5, 6), glm::vec3(7, 8, 9)};
    Inspection inspection;
    inspection.follow(state, [&](const NodePath&) { return turned; });
    REQUIRE(inspection.shown() != nullptr);
    CHECK(inspection.shown()->blend == turned);
    state.session.seek(0.5, 0);
    inspection.follow(state, [](const NodePath&) { return std::nullopt; });
    CHECK(inspection.shown()->blend == turned);
    const std::array<glm::vec3, 3> next = {glm::vec3(1), glm::vec3(2), glm::vec3(3)};
    inspection.follow(state, [&](const NodePath&) { return next; });
    CHECK(inspection.shown()->blend == next);
}

TEST_CASE("the inspector steps through the union, follows the blend, and ends with the roots") {
    ViewerState state(family_of(random_family(7, 3)));
    Inspection inspection;
    state.inspected = NodePath{};
    state.node_step = NodeStep::parent;
    inspection.follow(state);
    CHECK(state.inspected == NodePath{});
    CHECK_FALSE(state.node_step);

    state.node_step = NodeStep::first_child;
    const bool is_bisected = inspection.shown()->state == NodeState::bisected;
    inspection.follow(state);
    CHECK(state.inspected == (is_bisected ? NodePath{0, 1, 0} : NodePath{}));

    state.session.show_key(2, 0);
    inspection.follow(state);
    REQUIRE(inspection.shown()->keys.size() == 1);
    CHECK(inspection.shown()->keys[0].name == "c");

    ViewerState other(family_of(random_family(8, 3)));
    other.inspected = NodePath{};
    inspection.follow(other);
    CHECK_FALSE(other.inspected);
    CHECK(inspection.shown() == nullptr);
}

TEST_CASE("a node of another document is not inspected") {
    ViewerState state(family_of(random_family(1, 3)));
    state.inspected =
        NodePath{.root = state.document.family().keys.front().hierarchy->roots.triangle_count()};
    Inspection inspection;
    inspection.follow(state);
    CHECK(!state.inspected);
    CHECK(inspection.shown() == nullptr);
}
