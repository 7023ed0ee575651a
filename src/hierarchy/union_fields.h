// Fields of a union: a field that several keys have becomes one stream a key beside the positions, by the
// same rule: a key's own vertex keeps its value, every other vertex gets the mean of the ends of the edge it
// bisects.
//
// Colours become linear light on the way, so that means and morphs mix light. It is a pass for each key after
// the union, which costs nothing where no field is wanted.
#pragma once

#include <span>
#include <vector>

#include "hierarchy/hierarchy.h"
#include "hierarchy/union_mesh.h"

namespace interleaf {

/// The fields that all of \p keys, at least one, have under one name and of one kind, in the first key's
/// order.
std::vector<FieldName> common_fields(std::span<const Hierarchy* const> keys);

/// The field \p label of \p mesh, which is the union of \p keys.
/// \pre  each of \p keys has it, and passes check()
UnionField united_field(std::span<const Hierarchy* const> keys, const UnionMesh& mesh,
                        const FieldName& label);

/// Makes all common_fields() of \p keys the fields of \p mesh, which is their union.
void unite_fields(std::span<const Hierarchy* const> keys, UnionMesh& mesh);

}  // namespace interleaf
