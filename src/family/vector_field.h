// Vector fields: the components of a vector are scalars of their own, "v x", "v y" and "v z", as imported series name
// them.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "family/family_fields.h"

namespace interleaf {

struct VectorField {
    std::string name;                    ///< "v"
    std::array<std::string, 3> parts{};  ///< the scalars of x, y and z; the last is empty in two dimensions
    float largest = 0;                   ///< no vector is longer
    bool operator==(const VectorField&) const = default;
};

/// The vector of which the scalar \p name is a component; none if \p fields lack one for x or y.
std::optional<VectorField> vector_of(std::span<const FamilyField> fields, std::string_view name);

/// The vector of the components \p parts, of which the last may be empty; none if \p fields lack one of them as a
/// scalar.
std::optional<VectorField> vector_of_parts(std::span<const FamilyField> fields,
                                           const std::array<std::string, 3>& parts);

}  // namespace interleaf
