#include "text/fuzzy_match.h"

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

#include "text/characters.h"

namespace interleaf {

namespace {

/// The ranks of a word. Letters that are scattered in the text rank behind these, the farther apart the later.
enum WordRank : unsigned {
    begins_text = 0,
    begins_word = 1,
    are_initials = 2,
    is_part = 4,
    is_scattered = 8
};

bool is_separator(char letter) {
    return letter == ' ' || letter == '-' || letter == '_' || letter == '.' || letter == '/' || letter == ':';
}

bool begins_word_at(std::string_view text, std::size_t place) {
    return place == 0 || is_separator(text[place - 1]);
}

/// Whether \p word consists of first letters of words of \p text, in order. Words may be skipped.
bool has_initials(std::string_view word, std::string_view text) {
    std::size_t found = 0;
    for (std::size_t place = 0; place < text.size() && found < word.size(); ++place)
        if (begins_word_at(text, place) && text[place] == word[found]) ++found;
    return found == word.size();
}

/// The number of letters between the letters of \p word, which follow each other in \p text.
std::optional<unsigned> gaps_of(std::string_view word, std::string_view text) {
    std::size_t first = std::string_view::npos;
    std::size_t place = 0;
    for (const char letter : word) {
        place = text.find(letter, place);
        if (place == std::string_view::npos) return std::nullopt;
        if (first == std::string_view::npos) first = place;
        ++place;
    }
    return static_cast<unsigned>(place - first - word.size());
}

std::optional<unsigned> word_rank(std::string_view word, std::string_view text) {
    if (text.starts_with(word)) return begins_text;
    bool is_inside = false;
    for (std::size_t place = text.find(word); place != std::string_view::npos;
         place = text.find(word, place + 1)) {
        if (begins_word_at(text, place)) return begins_word;
        is_inside = true;
    }
    if (word.size() > 1 && has_initials(word, text)) return are_initials;
    if (is_inside) return is_part;
    const std::optional<unsigned> gaps = gaps_of(word, text);
    return gaps ? std::optional(is_scattered + *gaps) : std::nullopt;
}

/// The words of \p text, in lower case.
std::vector<std::string> words_of(std::string_view text) {
    std::vector<std::string> words;
    const std::string whole = folded(text);
    std::string_view rest = whole;
    while (!rest.empty()) {
        const std::size_t end = rest.find(' ');
        if (end != 0) words.emplace_back(rest.substr(0, end));
        rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 1);
    }
    return words;
}

}  // namespace

std::optional<unsigned> match_rank(std::string_view pattern, std::string_view text) {
    const std::string within = folded(text);
    unsigned rank = 0;
    for (const std::string& word : words_of(pattern)) {
        const std::optional<unsigned> here = word_rank(word, within);
        if (!here) return std::nullopt;
        rank += *here;
    }
    return rank;
}

bool contains_words(std::string_view words, std::string_view text) {
    const std::string within = folded(text);
    return std::ranges::all_of(
        words_of(words), [&](const std::string& word) { return within.find(word) != std::string::npos; });
}

}  // namespace interleaf
