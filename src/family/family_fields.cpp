#include "family/family_fields.h"

#include <algorithm>
#include <utility>

#include "hierarchy/union_fields.h"
#include "text/value_text.h"

namespace interleaf {
namespace {

const Hierarchy& hierarchy_of(const Key& key) {
    return *key.hierarchy;
}

std::vector<const Hierarchy*> active_hierarchies(const Family& family, const Weights& weights) {
    std::vector<const Hierarchy*> active;
    active.reserve(weights.size());
    for (const Weight& weight : weights) active.push_back(&hierarchy_of(family.keys[weight.key]));
    return active;
}

/// Extends the range of \p field to the values of \p other.
void include(FamilyField& field, const Field& other) {
    const auto [least, greatest] = std::ranges::minmax_element(other.values);
    field.min = std::min(field.min, *least);
    field.max = std::max(field.max, *greatest);
}

}  // namespace

std::vector<FamilyField> fields_of(std::span<const Key> keys, std::span<const FieldScale> scales) {
    std::vector<FamilyField> fields;
    for (const Key& key : keys)
        for (const Field& field : hierarchy_of(key).fields) {
            const auto known = std::ranges::find(
                fields, field.name, [](const FamilyField& each) -> auto& { return each.label.name; });
            if (known == fields.end()) {
                const float first = field.values.front();
                fields.push_back({.label = field.label(), .min = first, .max = first});
                include(fields.back(), field);
            } else if (known->label.kind == field.kind) {
                include(*known, field);
            }
        }
    for (FamilyField& field : fields) {
        if (field.label.kind != FieldKind::scalar) continue;
        FieldScale scale = scale_of(scales, field.label.name);
        field.offset = scale.offset;
        field.unit = std::move(scale.unit);
    }
    return fields;
}

std::vector<FamilyField> fields_of(const Family& family) {
    return fields_of(family.keys, family.field_scales);
}

const FamilyField* find_field(std::span<const FamilyField> fields, std::string_view name) {
    const auto found =
        std::ranges::find_if(fields, [&](const FamilyField& field) { return field.label.name == name; });
    return found == fields.end() ? nullptr : &*found;
}

std::string shown_value(const FamilyField& field, double value) {
    return with_unit(value_text(value + field.offset, double{field.max} - double{field.min}), field.unit);
}

std::optional<std::size_t> key_without(const Family& family, const Weights& weights, const FieldName& field) {
    const auto lacks_it = [&](const Weight& weight) {
        return find_field(hierarchy_of(family.keys[weight.key]).fields, field) == nullptr;
    };
    const auto found = std::ranges::find_if(weights, lacks_it);
    if (found == weights.end()) return std::nullopt;
    return found->key;
}

UnionField united_field(const Family& family, const Weights& weights, const UnionMesh& mesh,
                        const FieldName& field) {
    return united_field(active_hierarchies(family, weights), mesh, field);
}

void unite_fields(const Family& family, const Weights& weights, UnionMesh& mesh) {
    unite_fields(active_hierarchies(family, weights), mesh);
}

}  // namespace interleaf
