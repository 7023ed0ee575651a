// Finds names by a few letters of them, and ranks them.
#pragma once

#include <optional>
#include <string_view>

namespace interleaf {

/// How well \p text matches \p pattern, in any case; 0 is the best. Every word of the pattern must match, in any
/// order, and the ranks of the words add up. A word matches, from best to worst, the begin of the text, the begin
/// of a word in it, first letters of words in order ("gk" in "Go to key"), a part of the text, or letters of the
/// text in the same order, the closer together the better. An empty pattern matches every text equally.
/// \return none if \p text does not match
std::optional<unsigned> match_rank(std::string_view pattern, std::string_view text);

/// Whether every word of \p words is a part of \p text, in any case.
bool contains_words(std::string_view words, std::string_view text);

}  // namespace interleaf
