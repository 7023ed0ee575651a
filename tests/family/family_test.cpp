// Tests of the family: the invariants that check() tests, and the union of the active keys.
#include "family/family.h"

#include <algorithm>
#include <span>

#include <doctest/doctest.h>

using namespace interleaf;

namespace {

/// A tetrahedron whose vertices are moved up by \p offset.
Hierarchy tetrahedron(float offset) {
    return unrefined(RootComplex(4, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}),
                     {{0, 0, offset}, {1, 0, offset}, {0, 1, offset}, {0, 0, 1 + offset}});
}

/// The same tetrahedron with a different refinement edge in its last triangle.
Hierarchy marked_otherwise() {
    return unrefined(RootComplex(4, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {3, 2, 0}}),
                     {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
}

Family three_keys() {
    return {"three",
            {{"low", tetrahedron(0)}, {"middle", tetrahedron(1)}, {"high", tetrahedron(2)}},
            Timeline({{0, 0}, {1, 2}}),
            ParameterDomain({{{0, 0}, 0}, {{1, 0}, 1}, {{0, 1}, 2}}, {{0, 1, 2}})};
}

/// Whether there is exactly one violation, and it contains each of \p parts.
bool is_only_violation(const Family& family, std::initializer_list<const char*> parts) {
    const auto violations = check(family);
    if (violations.size() != 1) return false;
    CAPTURE(violations.front());
    return std::all_of(parts.begin(), parts.end(),
                       [&](const char* part) { return violations.front().find(part) != std::string::npos; });
}

bool is_stream_of(std::span<const glm::vec3> stream, const Key& key) {
    return std::equal(stream.begin(), stream.end(), key.hierarchy->positions.begin(),
                      key.hierarchy->positions.end());
}

}  // namespace

TEST_CASE("a sound family has no violation, with and without timeline and domain") {
    Family family = three_keys();
    CHECK(check(family).empty());
    family.timeline.reset();
    family.domain.reset();
    CHECK(check(family).empty());
}

TEST_CASE("keys are found by name") {
    CHECK(find_key(three_keys(), "middle") == 1);
    CHECK_FALSE(find_key(three_keys(), "Middle"));
    CHECK_FALSE(find_key(three_keys(), ""));
}

TEST_CASE("a family without keys is rejected") {
    Family family;
    CHECK(is_only_violation(family, {"no key"}));
}

TEST_CASE("a missing and a duplicate name are violations") {
    Family family = three_keys();
    family.keys[1].name = "";
    CHECK(is_only_violation(family, {"key 1 has no name"}));
    family.keys[1].name = "low";
    CHECK(is_only_violation(family, {"\"low\""}));
}

TEST_CASE("keys over different roots violate constraints (B), and are named") {
    Family family = three_keys();
    family.keys[2].hierarchy = marked_otherwise();
    CHECK(is_only_violation(family, {"\"low\"", "\"high\"", "root triangle 3"}));
    family.keys[2].hierarchy = unrefined(RootComplex(3, {{0, 1, 2}}), {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
    CHECK(is_only_violation(family, {"\"low\"", "\"high\"", "vertices"}));
}

TEST_CASE("a timeline and a domain that refer to keys that do not exist are violations") {
    Family family = three_keys();
    family.timeline = Timeline({{0, 0}, {1, 3}});
    CHECK(is_only_violation(family, {"timeline key 1", "key 3"}));
    family = three_keys();
    family.domain = ParameterDomain({{{0, 0}, 0}, {{1, 0}, 1}, {{0, 1}, 9}}, {{0, 1, 2}});
    CHECK(is_only_violation(family, {"domain vertex 2", "key 9"}));
}

TEST_CASE("the union has one stream per active key, even for weight 0, in the order of the weights") {
    const Family family = three_keys();
    const UnionMesh mesh = unite(family, {{0, 0}, {2, 1}});
    REQUIRE(mesh.key_count() == 2);
    CHECK(is_stream_of(mesh.positions[0], family.keys[0]));
    CHECK(is_stream_of(mesh.positions[1], family.keys[2]));

    UnionMesh reused = unite(family, {{0, 0.5}, {1, 0.25}, {2, 0.25}});
    CHECK(reused.key_count() == 3);
    unite(family, {{1, 1}}, reused);
    REQUIRE(reused.key_count() == 1);
    CHECK(is_stream_of(reused.positions[0], family.keys[1]));
}
