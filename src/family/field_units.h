// Edits of what a family knows about its fields (field_scale.h). Each returns the changed family.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "family/family.h"

namespace interleaf {

/// The unit of a scalar.
struct NamedUnit {
    std::string field;
    std::string unit;  ///< empty for none

    bool operator==(const NamedUnit&) const = default;
};

/// With \p unit as the unit of \p field; without one if \p unit is empty.
/// \throw InputError unless is_unit(), or if no key has a scalar \p field
Family with_field_unit(Family family, std::string_view field, std::string unit);

/// With \p unit as the unit of the times of the timeline; in seconds or steps if \p unit is empty.
/// \throw InputError unless is_unit(), or if the family has no timeline
Family with_time_unit(Family family, std::string unit);

/// Adds \p shift to the values of the scalar \p field of \p key, if it has one.
/// \param name  of the key, for the message
/// \throw InputError if a sum is no finite float
void shift_scalar(Hierarchy& key, std::string_view name, std::string_view field, double shift);

/// Brings \p keys, whose fields have the scales \p from, to the scales of \p family, to which they are to be added:
/// the values of a field get the offset that the family has for it. A field that no key of the family has keeps its
/// offset, and a field without unit gets the one of \p from.
/// \return the scales of the family with these keys
/// \throw InputError if a value with the other offset is no finite float
std::vector<FieldScale> adopt_scales(const Family& family, std::vector<Key>& keys,
                                     std::span<const FieldScale> from);

}  // namespace interleaf
