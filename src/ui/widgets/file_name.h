// Names of files as people read, order and type them. A name is bytes, mostly UTF-8: what is not, and what
// would not be seen or would turn the text around, is shown escaped.
#pragma once

#include <string>
#include <string_view>

namespace interleaf {

/// \p name with bytes that are not UTF-8 and control characters as \xNN, and invisible characters and those
/// that change the direction of writing as \u{N}. What it returns is UTF-8.
std::string shown_name(std::string_view name);

/// Whether a text field can hold \p name and give it back unchanged.
bool is_editable(std::string_view name);

/// \p text in lower case, letter by letter; what is not UTF-8 stays as it is.
std::string folded(std::string_view text);

/// Whether \p a comes before \p b, both folded: runs of digits by their value, so that flow.2 comes before
/// flow.10, all else by code points. A strict total order: of 7 and 07 the shorter comes first.
bool is_naturally_before(std::string_view a, std::string_view b);

}  // namespace interleaf
