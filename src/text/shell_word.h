// Texts as words of a command for a shell.
#pragma once

#include <string>
#include <string_view>

namespace interleaf {

/// \p text as one word of a POSIX shell, in single quotes.
std::string quoted_shell_word(std::string_view text);

}  // namespace interleaf
