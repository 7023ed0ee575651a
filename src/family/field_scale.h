// What a family knows about its fields besides the values of the keys: offsets and units.
//
// Floats have seven digits, so they keep little of a field such as 300 +- 0.1. As for positions (origin.h), an
// offset is therefore subtracted from all values of such a field in double precision, and added again where values
// are shown or written. A blend adds it once, whatever the sum of its weights.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace interleaf {

struct FieldScale {
    std::string field;   ///< name of a scalar of the keys
    double offset = 0;   ///< was subtracted from all values; finite
    std::string unit{};  ///< as people write it, "m/s"; empty if unknown
    bool operator==(const FieldScale&) const = default;
};

/// The limit on the bytes of a unit.
inline constexpr std::size_t max_unit = 64;

/// Whether \p text can be a unit: at most max_unit bytes, is_printable() (text/characters.h). Empty text can: the
/// unit is unknown.
bool is_unit(std::string_view text);

/// The scale of \p field: that of \p scales, or one without offset and unit.
FieldScale scale_of(std::span<const FieldScale> scales, std::string_view field);

/// Puts \p scale in the place of the scale of its field. Scales without offset and unit are dropped.
void set_scale(std::vector<FieldScale>& scales, FieldScale scale);

/// The offset for values from \p low to \p high: a number of few digits within the range, if floats would round the
/// values by more than a millionth of the range; otherwise 0. Also 0 if the values differ by rounding alone.
/// \pre \p low <= \p high, and both are finite
double offset_for(double low, double high);

/// A sentence that tells which number was subtracted from a field.
/// \pre the offset is not 0
std::string offset_sentence(const FieldScale& scale);

}  // namespace interleaf
