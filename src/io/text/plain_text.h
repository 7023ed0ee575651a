// Converts text files from different editors and systems to one plain form.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace interleaf {

/// \p text in UTF-8, without a byte order mark, with lines that end with "\n" or "\r\n". Converts UTF-16,
/// with or without a byte order mark, and replaces line ends of "\r" alone by "\n".
/// \param remarks  gets a sentence if the text was UTF-16
std::string plain_text(std::string text, std::vector<std::string>& remarks);

/// Whether \p bytes begin like text: without control characters other than blanks and line ends.
bool looks_like_text(std::string_view bytes);

}  // namespace interleaf
