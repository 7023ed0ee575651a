// The components of a vector are found by their names.
#include "family/vector_field.h"

#include <vector>

#include <doctest/doctest.h>

using namespace interleaf;

namespace {

FamilyField scalar(const char* name, float min, float max) {
    return {{name, FieldKind::scalar}, min, max};
}

}  // namespace

TEST_CASE("a vector has two or three components, and a bound of its length") {
    const std::vector<FamilyField> fields = {scalar("v x", -3, 1), scalar("v y", 0, 4), scalar("u", 0, 1),
                                             scalar("w x", 1, 2),  scalar("w y", 0, 2), scalar("w z", -1, 1)};
    const auto plane = vector_of(fields, "v y");
    REQUIRE(plane);
    CHECK(plane->name == "v");
    CHECK(plane->parts == std::array<std::string, 3>{"v x", "v y", ""});
    CHECK(plane->largest == 5);
    const auto space = vector_of(fields, "w x");
    REQUIRE(space);
    CHECK(space->parts[2] == "w z");
    CHECK(space->largest == 3);
    CHECK_FALSE(vector_of(fields, "u"));
    CHECK_FALSE(vector_of(std::vector{scalar("v x", 0, 1)}, "v x"));
    CHECK_FALSE(vector_of(std::vector{scalar(" x", 0, 1), scalar(" y", 0, 1)}, " x"));
}
