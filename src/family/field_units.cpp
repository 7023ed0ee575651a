#include "family/field_units.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <fmt/core.h>

#include "hierarchy/error.h"
#include "hierarchy/field.h"

namespace interleaf {
namespace {

bool have_scalar(std::span<const Key> keys, std::string_view name) {
    return std::ranges::any_of(keys, [&](const Key& key) {
        return find_field(key.hierarchy->fields, {std::string(name), FieldKind::scalar}) != nullptr;
    });
}

void require_unit(std::string_view unit) {
    if (!is_unit(unit))
        throw InputError(fmt::format("a unit is at most {} bytes without control characters", max_unit));
}

}  // namespace

Family with_field_unit(Family family, std::string_view field, std::string unit) {
    require_unit(unit);
    if (!have_scalar(family.keys, field))
        throw InputError(fmt::format("no key has a scalar field called \"{}\"", field));
    FieldScale scale = scale_of(family.field_scales, field);
    scale.unit = std::move(unit);
    set_scale(family.field_scales, std::move(scale));
    return family;
}

Family with_time_unit(Family family, std::string unit) {
    require_unit(unit);
    if (!family.timeline) throw InputError("the family has no timeline");
    family.time_unit = std::move(unit);
    return family;
}

void shift_scalar(Hierarchy& key, std::string_view name, std::string_view field, double shift) {
    if (shift == 0) return;
    for (Field& each : key.fields) {
        if (each.kind != FieldKind::scalar || each.name != field) continue;
        for (float& value : each.values) {
            const double sum = double{value} + shift;
            if (!(std::abs(sum) <= double{std::numeric_limits<float>::max()}))
                throw InputError(fmt::format(
                    "key \"{}\": the offset of the field \"{}\" is too far from that of the other keys", name,
                    field));
            value = static_cast<float>(sum);
        }
    }
}

std::vector<FieldScale> adopt_scales(const Family& family, std::vector<Key>& keys,
                                     std::span<const FieldScale> from) {
    std::vector<FieldScale> scales = family.field_scales;
    std::vector<std::string> names;
    for (const Key& key : keys)
        for (const Field& field : key.hierarchy->fields)
            if (field.kind == FieldKind::scalar && std::ranges::find(names, field.name) == names.end())
                names.push_back(field.name);
    for (const std::string& name : names) {
        const FieldScale theirs = scale_of(from, name);
        FieldScale ours = scale_of(scales, name);
        if (!have_scalar(family.keys, name)) ours.offset = theirs.offset;
        if (ours.unit.empty()) ours.unit = theirs.unit;
        const double shift = theirs.offset - ours.offset;
        for (Key& key : keys) {
            if (shift == 0 || !have_scalar(std::span(&key, 1), name)) continue;
            Hierarchy shifted = *key.hierarchy;
            shift_scalar(shifted, key.name, name, shift);
            key.hierarchy = std::move(shifted);
        }
        set_scale(scales, std::move(ours));
    }
    return scales;
}

}  // namespace interleaf
