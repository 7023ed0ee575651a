// What is wrong, said on standard error.
#pragma once

#include <string_view>

namespace interleaf {

/// Prints the line "interleaf: TEXT", as shown_text() makes it; \p text is what() of one of our errors.
void print_error(std::string_view text);

}  // namespace interleaf
