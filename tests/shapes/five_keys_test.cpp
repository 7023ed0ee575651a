// Tests of the shipped family against the generator.
#include <algorithm>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "family/family.h"
#include "io/family/family_file.h"
#include "shapes/shapes.h"

using namespace interleaf;

TEST_CASE("the shipped keys equal the generator's keys: same roots and bits, positions to 1e-6") {
    const Family family = read_family(FIVE_KEYS_FOLDER);
    REQUIRE(family.keys.size() == five_keys().size());
    for (const ShippedKey& shipped : five_keys()) {
        CAPTURE(shipped.shape);
        const auto number = find_key(family, shipped.shape);
        REQUIRE(number.has_value());
        const Hierarchy& read = *family.keys[*number].hierarchy;
        const Hierarchy made = make_key(*find_shape(shipped.shape), shipped.budget);
        CHECK(read.roots == made.roots);
        CHECK(read.bits == made.bits);
        CHECK(read.midpoints == made.midpoints);
        REQUIRE(read.positions.size() == made.positions.size());
        for (std::size_t v = 0; v < made.positions.size(); ++v) {
            CHECK(glm::distance(read.positions[v], made.positions[v]) <= 1e-6F);
        }
    }
}

TEST_CASE("the shipped icosahedron has its 20 roots, the others have 5,000 to 40,000 leaves, all different") {
    std::vector<std::size_t> counts;
    for (const Key& key : read_family(FIVE_KEYS_FOLDER).keys) {
        counts.push_back(key.hierarchy->leaf_count());
        if (key.name == "icosahedron") {
            CHECK(counts.back() == 20);
        } else {
            CHECK(counts.back() >= 5000);
            CHECK(counts.back() <= 40000);
        }
    }
    std::sort(counts.begin(), counts.end());
    CHECK(std::adjacent_find(counts.begin(), counts.end()) == counts.end());
}

TEST_CASE("the shipped domain is the square of the paper's figure 8") {
    const Family family = read_family(FIVE_KEYS_FOLDER);
    REQUIRE(family.domain.has_value());
    CHECK(family.domain->triangles().size() == 4);
    const auto key_at = [&](const glm::dvec2& at) {
        const Weights weights = family.domain->weights(family.domain->locate(at));
        const auto most =
            std::max_element(weights.begin(), weights.end(),
                             [](const Weight& a, const Weight& b) { return a.value < b.value; });
        CHECK(most->value == 1);
        return family.keys[most->key].name;
    };
    CHECK(key_at({-1, -1}) == "icosahedron");
    CHECK(key_at({1, -1}) == "bone");
    CHECK(key_at({1, 1}) == "cushion");
    CHECK(key_at({-1, 1}) == "star");
    CHECK(key_at({0, 0}) == "sphere");
}

TEST_CASE("the shipped timeline visits all keys, stays on points of the domain, and ends where it began") {
    const Family family = read_family(FIVE_KEYS_FOLDER);
    REQUIRE(family.timeline.has_value());
    REQUIRE(family.domain.has_value());
    const auto keys = family.timeline->keys();
    for (std::size_t key = 0; key < family.keys.size(); ++key) {
        CHECK(std::any_of(keys.begin(), keys.end(),
                          [&](const TimelineKey& entry) { return entry.key == key; }));
    }
    CHECK(keys.front().key == keys.back().key);
    for (double time = family.timeline->begin(); time <= family.timeline->end(); time += 0.125) {
        CAPTURE(time);
        CHECK(family.domain->point_of(family.timeline->at(time)).has_value());
    }
}
