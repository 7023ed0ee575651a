#include "family/new_family.h"

#include <set>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

using namespace interleaf;

namespace {

Family family_of(std::size_t count) {
    std::vector<Key> keys;
    for (std::size_t n = 0; n < count; ++n)
        keys.push_back({"k", unrefined(RootComplex(3, {{0, 1, 2}}), {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}})});
    return family_of_keys("new", std::move(keys));
}

}  // namespace

TEST_CASE("a new family is sound: unique names, one second from key to key, each key once in the domain") {
    for (std::size_t count = 1; count <= 30; ++count) {
        CAPTURE(count);
        const Family family = family_of(count);
        REQUIRE(check(family).empty());
        REQUIRE(family.timeline.has_value() == (count >= 2));
        REQUIRE(family.domain.has_value() == (count >= 3 && count <= 9));
        for (std::size_t n = 0; family.timeline && n < count; ++n)
            REQUIRE(family.timeline->keys()[n] == TimelineKey{static_cast<double>(n), n});
        if (!family.domain) continue;
        std::set<std::size_t> keys;
        for (const DomainVertex& vertex : family.domain->vertices()) keys.insert(vertex.key);
        REQUIRE(keys.size() == count);
        REQUIRE(family.domain->vertices().size() == count);
        REQUIRE(family.domain->triangles().size() == (count == 3 ? 1 : count - 1));
    }
}

TEST_CASE("the domain of four keys or more has the first key in the middle of a regular polygon on a side") {
    const Family five = family_of(5);
    const auto vertices = five.domain->vertices();
    CHECK(vertices[0] == DomainVertex{{0, 0}, 0});
    CHECK(vertices[1].at.y == vertices[2].at.y);
    CHECK(vertices[1].at.y < 0);
    for (std::size_t n = 1; n < 5; ++n) CHECK(glm::length(vertices[n].at) == doctest::Approx(1));
    CHECK(five.domain->weights(five.domain->locate({0, 0})).size() == 3);
}

TEST_CASE("duplicate names get a number, empty names a default") {
    std::vector<Key> keys = family_of(1).keys;
    keys.push_back(keys[0]);
    keys.push_back(keys[0]);
    keys[1].name = "k 2";
    keys.push_back(keys[0]);
    keys[3].name = "";
    const Family family = family_of_keys("new", keys);
    CHECK(family.keys[0].name == "k");
    CHECK(family.keys[1].name == "k 2");
    CHECK(family.keys[2].name == "k 3");
    CHECK(family.keys[3].name == "key");
}

TEST_CASE("names that nobody may have are escaped, so that the family can be saved") {
    std::vector<Key> keys = family_of(1).keys;
    keys[0].name = "a\nb\xff";
    const Family family = family_of_keys("c\u009bd", keys);
    CHECK(family.name == "c\\xc2\\x9bd");
    CHECK(family.keys[0].name == "a\\x0ab\\xff");
    CHECK(check(family).empty());
}
