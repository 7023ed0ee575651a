// Text files as editors and other systems write them, made plain.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace interleaf {

/// \p text in UTF-8 without a byte order mark, its lines ended by "\n" or "\r\n". UTF-16, with such a mark or
/// without one, is converted, and lines that are ended by "\r" alone get "\n".
/// \param remarks  gets a sentence where the text was UTF-16
std::string plain_text(std::string text, std::vector<std::string>& remarks);

/// Whether \p bytes begin as text does: without control characters but blanks and ends of lines.
bool looks_like_text(std::string_view bytes);

}  // namespace interleaf
