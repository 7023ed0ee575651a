// What is wrong, said on standard error.
#pragma once

#include <string_view>

namespace interleaf {

/// Prints the line "interleaf: TEXT"; \p text is what() of one of our errors. It may hold names of files, so
/// control characters in it are escaped.
void print_error(std::string_view text);

}  // namespace interleaf
