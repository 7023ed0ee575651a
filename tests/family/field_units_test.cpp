#include "family/field_units.h"

#include <doctest/doctest.h>

#include "hierarchy/error.h"

using namespace interleaf;

namespace {

Key triangle_with(std::string name, std::vector<Field> fields) {
    Hierarchy triangle = unrefined(RootComplex(3, {{0, 1, 2}}), {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
    triangle.fields = std::move(fields);
    return {std::move(name), std::move(triangle)};
}

Family family_of(Key key) {
    Family family{.name = "f", .keys = {std::move(key)}, .timeline = {}, .domain = {}};
    return family;
}

Field scalar(const char* name, float value) {
    return {name, FieldKind::scalar, {value, value, value}};
}

}  // namespace

TEST_CASE("units belong to scalars of the keys, and to a timeline") {
    Family family =
        family_of(triangle_with("a", {scalar("T", 1), {"c", FieldKind::color, Buffer<float>(9, 0)}}));
    family.field_scales = {{"T", 300, ""}};
    family = with_field_unit(family, "T", "K");
    CHECK(family.field_scales == std::vector<FieldScale>{{"T", 300, "K"}});
    CHECK(check(family).empty());
    CHECK_THROWS_AS(with_field_unit(family, "u", "K"), InputError);
    CHECK_THROWS_AS(with_field_unit(family, "c", "K"), InputError);
    CHECK_THROWS_AS(with_field_unit(family, "T", "a\tb"), InputError);
    CHECK_THROWS_AS(with_time_unit(family, "ms"), InputError);
    family.timeline = Timeline({{0, 0}});
    CHECK(with_time_unit(family, "ms").time_unit == "ms");
    CHECK_THROWS_AS(with_time_unit(family, "a\tb"), InputError);
}

TEST_CASE("faulty scales are named") {
    Family family = family_of(triangle_with("a", {}));
    family.field_scales = {{"T", 1, ""}, {"T", 2, ""}};
    CHECK(check(family).size() == 1);
    family.field_scales = {{"", 1, ""}};
    CHECK(check(family).size() == 1);
}

TEST_CASE("keys that are added get the offsets of the family, and bring those it does not know") {
    Family family = family_of(triangle_with("a", {scalar("T", 2), scalar("p", 5)}));
    family.field_scales = {{"T", 300, ""}};
    std::vector<Key> keys = {triangle_with("b", {scalar("T", -1), scalar("p", 1), scalar("q", 3)})};
    const std::vector<FieldScale> from = {{"T", 310, "K"}, {"p", 1000, "Pa"}, {"q", 70, ""}};
    family.field_scales = adopt_scales(family, keys, from);
    CHECK(family.field_scales == std::vector<FieldScale>{{"T", 300, "K"}, {"p", 0, "Pa"}, {"q", 70, ""}});
    const auto value = [&](std::size_t field) { return keys[0].hierarchy->fields[field].values[1]; };
    CHECK(value(0) == 9);     // 309 - 300
    CHECK(value(1) == 1001);  // without an offset
    CHECK(value(2) == 3);     // as it came
}

TEST_CASE("keys are not added whose values are no floats with the offset of the family") {
    const Family family = family_of(triangle_with("a", {scalar("T", 2)}));
    for (const double offset : {1e300, -1e39}) {
        std::vector<Key> keys = {triangle_with("b", {scalar("T", 1)})};
        const std::vector<FieldScale> from = {{"T", offset, ""}};
        CHECK_THROWS_AS(adopt_scales(family, keys, from), InputError);
    }
}
