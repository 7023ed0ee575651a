// Warps move flat keys across their plane, and nothing else.
#include "family/warp.h"

#include <doctest/doctest.h>

using namespace interleaf;

namespace {

/// A triangle in the plane y = 2.
Hierarchy flat_key() {
    Hierarchy key;
    key.roots = RootComplex(3, {{0, 1, 2}});
    key.bits = {0};
    key.positions = {{0, 2, 0}, {4, 2, 0}, {0, 2, 1}};
    key.fields = {{"u", FieldKind::scalar, {1, 3, 5}}, {"color", FieldKind::color, Buffer<float>(9, 0.5F)}};
    return key;
}

}  // namespace

TEST_CASE("a box is flat across its thin axis") {
    CHECK(flat_axis({{0, 2, 0}, {4, 2, 1}}) == 1U);
    CHECK(flat_axis({{0, 0, -1}, {4, 2, -1}}) == 2U);
    CHECK(flat_axis({{3, 0, -1}, {3.000001F, 2, 1}}) == 0U);
    CHECK_FALSE(flat_axis({{0, 0, 0}, {4, 2, 0.1F}}));
}

TEST_CASE("a warp moves positions by the field, relative to a zero") {
    const Hierarchy key = flat_key();
    const Hierarchy raised = warped(key, {.axis = 1, .field = "u", .factor = 0.5F, .zero = 1});
    CHECK(raised.positions[0] == glm::vec3(0, 2, 0));
    CHECK(raised.positions[1] == glm::vec3(4, 3, 0));
    CHECK(raised.positions[2] == glm::vec3(0, 4, 1));
    CHECK(raised.fields.size() == 2);
}

TEST_CASE("a key without the scalar stays as it is") {
    CHECK(warped(flat_key(), {.axis = 1, .field = "w"}).positions == flat_key().positions);
    CHECK(warped(flat_key(), {.axis = 1, .field = "color"}).positions == flat_key().positions);
}
