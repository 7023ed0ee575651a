#include "family/family_fields.h"

#include <span>

#include <doctest/doctest.h>

#include "hierarchy/union_fields.h"

using namespace interleaf;

namespace {

Key key_with(std::string name, std::vector<Field> fields) {
    Hierarchy triangle = unrefined(RootComplex(3, {{0, 1, 2}}), {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
    triangle.fields = std::move(fields);
    return {std::move(name), std::move(triangle)};
}

Family three_keys_with_fields() {
    const Field color{"color", FieldKind::color, {0, 0, 0, 1, 1, 1, 0.5F, 0.5F, 0.5F}};
    Family family{.name = "three", .keys = {}, .timeline = {}, .domain = {}};
    family.keys = {
        key_with("a", {{"T", FieldKind::scalar, {1, 2, 3}}, color}),
        key_with("b", {color, {"T", FieldKind::scalar, {-1, 0, 1}}, {"p", FieldKind::scalar, {7, 7, 7}}}),
        key_with("c", {{"T", FieldKind::scalar, {5, 0, 0}}, {"p", FieldKind::color, color.values}})};
    return family;
}

}  // namespace

TEST_CASE(
    "a family has each field once, with the first key's kind and the range over all keys that have it") {
    const std::vector<FamilyField> fields = fields_of(three_keys_with_fields().keys);
    REQUIRE(fields.size() == 3);
    CHECK(fields[0].label == FieldName{"T", FieldKind::scalar});
    CHECK(fields[0].min == -1);
    CHECK(fields[0].max == 5);
    CHECK(fields[1].label == FieldName{"color", FieldKind::color});
    CHECK(fields[2].label == FieldName{"p", FieldKind::scalar});
    CHECK(fields[2].min == 7);
    CHECK(fields[2].max == 7);
    CHECK(find_field(fields, "p") == &fields[2]);
    CHECK(find_field(fields, "q") == nullptr);
    CHECK(fields_of(std::span<const Key>()).empty());
}

TEST_CASE("key_without finds the first active key without the field, or with another kind of it") {
    const Family family = three_keys_with_fields();
    const FieldName p{"p", FieldKind::scalar};
    CHECK_FALSE(key_without(family, {{1, 1.0}}, p));
    CHECK(key_without(family, {{0, 0.5}, {1, 0.5}}, p) == 0);
    CHECK(key_without(family, {{1, 0.5}, {2, 0.5}}, p) == 2);
    CHECK_FALSE(key_without(family, {{0, 0.2}, {1, 0.3}, {2, 0.5}}, {"T", FieldKind::scalar}));
}

TEST_CASE("the fields of active keys are united in the order of the keys") {
    const Family family = three_keys_with_fields();
    const Weights weights{{0, 0.5}, {2, 0.5}};
    UnionMesh mesh = unite(family, weights);
    const UnionField united = united_field(family, weights, mesh, {"T", FieldKind::scalar});
    REQUIRE(united.values.size() == 2);
    CHECK(united.values[1] == Buffer<float>{5, 0, 0});
    unite_fields(family, weights, mesh);
    REQUIRE(mesh.fields.size() == 1);
    CHECK(mesh.fields[0].values == united.values);
}
