// The natural order of names, in which numbers count by their value: flow.2 before flow.10. The file browser
// lists files in it, and files that stand for a series are read in it.
#pragma once

#include <compare>
#include <string>
#include <string_view>

namespace interleaf {

/// A name with what it is sorted by, computed once per name.
struct NaturalName {
    NaturalName() = default;
    explicit NaturalName(std::string_view text);

    std::string text;
    std::string folded;  ///< the text in lower case (characters.h)

    /// A strict total order. Runs of digits compare by their value, all else by code point, first in lower
    /// case; names that differ in case or in leading zeros alone compare byte by byte, so 07 comes before 7.
    std::strong_ordering operator<=>(const NaturalName& other) const;
    bool operator==(const NaturalName& other) const { return text == other.text; }
};

/// \p text with each run of digits replaced by one 0: equal for all names of a numbered series.
std::string without_numbers(std::string_view text);

}  // namespace interleaf
