// Tests of the shading that suits the active keys.
#include "app/document/shown_shading.h"

#include <memory>
#include <string_view>

#include <doctest/doctest.h>

#include "shapes/shapes.h"

using namespace interleaf;

namespace {

Hierarchy key_of(std::string_view shape, std::size_t leaves) {
    ShapeBudget budget;
    budget.leaves = static_cast<Index>(leaves);
    return make_key(*find_shape(shape), budget);
}

/// A key of few leaves and one of many.
Session session_of_two_keys() {
    Family family;
    family.keys.push_back({"coarse", key_of("icosahedron", 20)});
    family.keys.push_back({"fine", key_of("sphere", 2000)});
    return Session(std::make_shared<const Family>(std::move(family)));
}

}  // namespace

TEST_CASE("the surface is flat where all active keys have few leaves") {
    Session session = session_of_two_keys();
    session.show_key(0, 0);
    CHECK(shown_shading(session) == Shading::flat);
    session.show_key(1, 0);
    CHECK(shown_shading(session) == Shading::smooth);
    session.set_weights({{0, 1.0}, {1, 0.0}}, 0);
    CHECK(shown_shading(session) == Shading::smooth);
}

TEST_CASE("the chosen shading holds for all keys") {
    Session session = session_of_two_keys();
    for (const Shading chosen : {Shading::smooth, Shading::flat}) {
        session.display.shading = chosen;
        for (const std::size_t key : {0UL, 1UL}) {
            session.show_key(key, 0);
            CHECK(shown_shading(session) == chosen);
        }
    }
}
