// Prints error messages on standard error.
#pragma once

#include <string_view>

namespace interleaf {

/// Prints the line "interleaf: TEXT". shown_text() escapes the text.
/// \param text  what() of an error of Interleaf
void print_error(std::string_view text);

}  // namespace interleaf
