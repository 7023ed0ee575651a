// The fields of a family: a name that keys use for a field, so that the field can be shown during a morph.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "family/family.h"
#include "hierarchy/field.h"

namespace interleaf {

struct FamilyField {
    FieldName label;
    float min = 0;  ///< over all keys that have the field
    float max = 0;
    double offset = 0;   ///< is added to values where they are shown (field_scale.h)
    std::string unit{};  ///< empty if unknown
};

/// One field per name, in the order of the first keys that have them. If keys have fields of one name but of
/// different kinds, the first key's kind counts, and keys with another kind count as not having the field.
/// \param scales  the offsets and units that are known
std::vector<FamilyField> fields_of(std::span<const Key> keys, std::span<const FieldScale> scales = {});

/// The fields of the keys of \p family, with offsets and units.
std::vector<FamilyField> fields_of(const Family& family);

/// The field called \p name; null if there is none.
const FamilyField* find_field(std::span<const FamilyField> fields, std::string_view name);

/// \p value of \p field as people read it: with offset, unit, and as many digits as the range of the field needs.
/// \param value  without the offset
std::string shown_value(const FamilyField& field, double value);

/// The first of the active keys of \p weights that does not have the field, as an index in the family; none
/// if all have it.
std::optional<std::size_t> key_without(const Family& family, const Weights& weights, const FieldName& field);

/// The field of \p mesh, the union of the active keys of \p weights.
/// \pre  key_without() finds no key
UnionField united_field(const Family& family, const Weights& weights, const UnionMesh& mesh,
                        const FieldName& field);

/// Gives \p mesh, the union of the active keys, all fields that these keys have in common.
void unite_fields(const Family& family, const Weights& weights, UnionMesh& mesh);

}  // namespace interleaf
