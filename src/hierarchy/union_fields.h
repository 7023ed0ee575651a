// Fields of a union. A field that all keys have becomes one stream per key, by the same rule as positions: a
// key's own vertex keeps its value, and every other vertex gets the mean of the ends of the edge it bisects.
//
// Colors become linear light here, so that means and morphs mix light. The fields take one pass per key after
// the union, and cost nothing if no field is wanted.
#pragma once

#include <span>
#include <vector>

#include "hierarchy/hierarchy.h"
#include "hierarchy/union_mesh.h"

namespace interleaf {

/// The fields that all of \p keys have with the same name and kind, in the first key's order.
/// \pre  there is at least one key
std::vector<FieldName> common_fields(std::span<const Hierarchy* const> keys);

/// The field \p label of \p mesh, which is the union of \p keys.
/// \pre  each of \p keys has the field, and passes check()
UnionField united_field(std::span<const Hierarchy* const> keys, const UnionMesh& mesh,
                        const FieldName& label);

/// Makes all common_fields() of \p keys the fields of \p mesh, which is their union.
void unite_fields(std::span<const Hierarchy* const> keys, UnionMesh& mesh);

}  // namespace interleaf
