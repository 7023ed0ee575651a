// The fields of a family: what its keys have under one name, so that it can be shown while they morph.
#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "family/family.h"
#include "hierarchy/field.h"

namespace interleaf {

struct FamilyField {
    FieldName label;
    float min = 0;  ///< over all keys that have it
    float max = 0;
};

/// One for each name, in the order of the first keys that have them. Where keys have fields of one name but
/// of different kinds, the first key's kind counts, and the others do not have it.
std::vector<FamilyField> fields_of(std::span<const Key> keys);

/// The one called \p name; null when there is none.
const FamilyField* find_field(std::span<const FamilyField> fields, std::string_view name);

/// The first of the active keys of \p weights that does not have the field, as an index of the family; none
/// when all have it.
std::optional<std::size_t> key_without(const Family& family, const Weights& weights, const FieldName& field);

/// The field of \p mesh, the union of the active keys of \p weights.
/// \pre key_without() finds none
UnionField united_field(const Family& family, const Weights& weights, const UnionMesh& mesh,
                        const FieldName& field);

/// Makes all fields that the active keys have in common those of \p mesh, their union.
void unite_fields(const Family& family, const Weights& weights, UnionMesh& mesh);

}  // namespace interleaf
