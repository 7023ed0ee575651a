// Text from outside, names of files above all, made fit to be shown.
#pragma once

#include <string>
#include <string_view>

namespace interleaf {

/// \p text for a terminal: every control character, and every byte that is not UTF-8, as \xNN. So \p text
/// moves no cursor and begins no line, and different names stay different. The result is_printable()
/// (characters.h).
std::string shown_text(std::string_view text);

/// The same for the window, where the fonts draw names: invisible characters, and those that change the
/// direction of writing, as \u{N}, too.
std::string shown_name(std::string_view name);

}  // namespace interleaf
