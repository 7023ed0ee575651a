// The warped family holds the active keys alone, warped once.
#include "app/pictures/warped_family.h"

#include <doctest/doctest.h>

#include "family/new_family.h"

using namespace interleaf;

namespace {

/// Three triangles with a field "u", which is \p u everywhere.
Family flat_family() {
    std::vector<Key> keys;
    for (const float u : {1.0F, 2.0F, 3.0F}) {
        Hierarchy key;
        key.roots = RootComplex(3, {{0, 1, 2}});
        key.bits = {0};
        key.positions = {{0, 0, 0}, {4, 0, 0}, {0, 2, 0}};
        key.fields = {{"u", FieldKind::scalar, Buffer<float>(3, u)}};
        keys.push_back({std::string(1, static_cast<char>('a' + keys.size())), std::move(key)});
    }
    return family_of_keys("flat", std::move(keys));
}

}  // namespace

TEST_CASE("without a warp the family is shown as it is") {
    const Family family = flat_family();
    WarpedFamily shown;
    shown.follow(family, {{1, 1.0}}, {}, std::nullopt);
    CHECK_FALSE(shown.is_warped());
    CHECK(&shown.family() == &family);
    CHECK(shown.weights() == Weights{{1, 1.0}});
    CHECK(shown.sources().empty());
}

TEST_CASE("with a warp the active keys are raised, each once") {
    const Family family = flat_family();
    const Warp warp{.axis = 2, .field = "u", .factor = 2, .zero = 1};
    WarpedFamily shown;
    shown.follow(family, {{0, 0.25}, {2, 0.75}}, {}, warp);
    REQUIRE(shown.family().keys.size() == 2);
    CHECK(shown.weights() == Weights{{0, 0.25}, {1, 0.75}});
    CHECK(shown.sources() == std::vector<std::size_t>{0, 2});
    CHECK(shown.family().keys[1].name == "c");
    CHECK(shown.family().keys[1].hierarchy->positions[1] == glm::vec3(4, 0, 4));
    const SharedHierarchy raised = shown.family().keys[1].hierarchy;
    shown.follow(family, {{1, 0.5}, {2, 0.5}}, {}, warp);
    CHECK(shown.family().keys[1].hierarchy.is_same(raised));
    shown.follow(family, {{2, 1.0}}, {}, Warp{.axis = 2, .field = "u", .factor = 1, .zero = 1});
    CHECK_FALSE(shown.family().keys[0].hierarchy.is_same(raised));
}
