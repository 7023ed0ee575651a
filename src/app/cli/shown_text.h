// Text that may hold names of files, or anything else, made fit for a terminal and for one line.
#pragma once

#include <string>
#include <string_view>

namespace interleaf {

/// \p text with every control character, and every byte that is no UTF-8, as \xNN: so it moves no cursor,
/// begins no line, and the name of a file can be told from another's.
std::string shown_text(std::string_view text);

}  // namespace interleaf
