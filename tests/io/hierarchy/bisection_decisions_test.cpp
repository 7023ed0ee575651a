#include "io/hierarchy/bisection_decisions.h"

#include <algorithm>
#include <random>

#include "scratch_folder.h"
#include "thrown_errors.h"
#include "trials.h"
#include <doctest/doctest.h>

#include "hierarchy/checker.h"
#include "hierarchy/error.h"
#include "hierarchy/random_families.h"
#include "io/hierarchy/position_prediction.h"
#include "io/samples.h"

namespace interleaf {

namespace {

using testing::for_random_families;
using testing::Random;
using testing::RandomFamily;

Connectivity rebuilt(const Hierarchy& hierarchy, std::span<const std::byte> decisions) {
    return rebuilt_connectivity(hierarchy.roots, static_cast<Index>(hierarchy.midpoints.size()),
                                static_cast<Index>(hierarchy.vertex_count()), decisions);
}

/// A sheet whose first leaf is bisected until a leaf lies 64 levels deep.
Hierarchy deepest() {
    AdaptiveMesh mesh(testing::sheet(1, 1), std::vector<glm::vec3>(4));
    while (mesh.level(mesh.preorder().front()) < max_level) {
        const Index leaf = mesh.preorder().front();
        mesh.refine({&leaf, 1});
    }
    return mesh.freeze();
}

}  // namespace

TEST_CASE("connectivity follows from the open decisions") {
    std::size_t leaves = 0;
    std::size_t decisions = 0;
    for_random_families(1000, 2, [&](const RandomFamily& family) {
        CAPTURE(family.seed);
        for (const Hierarchy& key : family.keys) {
            const DecidedConnectivity decided = open_decisions(key);
            const Connectivity connectivity = rebuilt(key, decided.decisions);
            CHECK(std::ranges::equal(connectivity.bits, key.bits));
            CHECK(std::ranges::equal(connectivity.midpoints, key.midpoints));
            leaves += key.leaf_count();
            decisions += decided.decisions.size();
        }
    });
    CHECK(decisions < leaves);
}

TEST_CASE("leaves of the largest depth are rebuilt") {
    const Hierarchy key = deepest();
    REQUIRE(check(key).empty());
    CHECK(std::ranges::equal(rebuilt(key, open_decisions(key).decisions).bits, key.bits));
}

TEST_CASE("every midpoint has its edge and the apexes on both sides") {
    for_random_families(200, 1, [&](const RandomFamily& family) {
        CAPTURE(family.seed);
        const Hierarchy& key = family.keys[0];
        const Connectivity connectivity = open_decisions(key).connectivity;
        std::vector<Triangle> pending;
        std::size_t position = 0;
        auto midpoint = key.midpoints.begin();
        for (const Triangle& root : key.roots.triangles()) {
            pending.push_back(root);
            while (!pending.empty()) {
                const Triangle node = pending.back();
                pending.pop_back();
                if (!key.is_bisected(position++)) continue;
                const MidpointStar& star = connectivity.stars[*midpoint];
                const bool is_first_side = star.apexes[0] == node[0] && star.ends[0] == node[1];
                CHECK(star.ends[is_first_side ? 0 : 1] == node[1]);
                CHECK(star.ends[is_first_side ? 1 : 0] == node[2]);
                CHECK(star.apexes[is_first_side ? 0 : 1] == node[0]);
                const auto [first, second] = bisect(node, *midpoint++);
                pending.push_back(second);
                pending.push_back(first);
            }
        }
    });
}

TEST_CASE("the ends of an edge come before its midpoint, whatever the marking") {
    for_random_families(1000, 2, [&](const RandomFamily& family) {
        CAPTURE(family.seed);
        for (const Hierarchy& key : family.keys) {
            const Connectivity connectivity = open_decisions(key).connectivity;
            const Buffer<Index> order = prediction_order(connectivity.levels);
            std::vector<std::size_t> place(order.size());
            for (std::size_t row = 0; row < order.size(); ++row) place[order[row]] = row;
            for (Index v = key.roots.vertex_count(); v < order.size(); ++v)
                for (const Index end : connectivity.stars[v].ends) CHECK(place[end] < place[v]);
        }
    });
}

TEST_CASE("any decisions give a sound hierarchy or are rejected") {
    int sound = 0;
    int refused = 0;
    for_random_families(2000, 1, [&](const RandomFamily& family) {
        CAPTURE(family.seed);
        Random random(family.seed);
        Hierarchy key = family.keys[0];
        Buffer<std::byte> decisions = open_decisions(key).decisions;
        // Swapping two decisions keeps most counts.
        const std::size_t a = random.below(decisions.size());
        const std::size_t b = random.below(decisions.size());
        if (random.chance(0.7))
            std::swap(decisions[a], decisions[b]);
        else
            decisions[a] = static_cast<std::byte>(random.below(4));
        try {
            Connectivity connectivity = rebuilt(key, decisions);
            key.bits = std::move(connectivity.bits);
            key.midpoints = std::move(connectivity.midpoints);
            CHECK(check(key).empty());
            ++sound;
        } catch (const InputError&) {
            ++refused;
        }
    });
    CHECK(sound > trials(300));
    CHECK(refused > trials(300));
}

TEST_CASE("decisions that do not fit the counts are reported") {
    std::mt19937 random(7);
    const Hierarchy key = random_hierarchy(random, false, 20);
    const auto midpoints = static_cast<Index>(key.midpoints.size());
    const auto vertices = static_cast<Index>(key.vertex_count());
    Buffer<std::byte> decisions = open_decisions(key).decisions;
    const auto error_of = [&](Index midpoint_count, Index vertex_count) {
        return input_error_of(
            [&] { rebuilt_connectivity(key.roots, midpoint_count, vertex_count, decisions); });
    };
    CHECK(error_of(midpoints, vertices).empty());
    CHECK(error_of(midpoints - 1, vertices).ends_with("midpoints"));
    CHECK(error_of(midpoints, vertices - 1).ends_with("vertices"));
    CHECK(error_of(midpoints + 1, vertices).find("bisected nodes") != std::string::npos);
    decisions.push_back(std::byte{0});
    CHECK(error_of(midpoints, vertices).find("decisions, expected") != std::string::npos);
    decisions[3] = std::byte{2};
    CHECK(error_of(midpoints, vertices) == "decision 3 is 2, expected 0 or 1");
}

}  // namespace interleaf
