// Texts with a separator between them: joined, and taken apart.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace interleaf {

inline std::string joined(std::span<const std::string> texts, std::string_view separator) {
    std::string result;
    for (const std::string& text : texts) {
        if (!result.empty()) result += separator;
        result += text;
    }
    return result;
}

/// The parts of \p text between the separators, which may be empty: one more than there are separators.
inline std::vector<std::string_view> split_at(std::string_view text, char separator) {
    std::vector<std::string_view> parts;
    for (;;) {
        const std::size_t end = text.find(separator);
        parts.push_back(text.substr(0, end));
        if (end == std::string_view::npos) return parts;
        text.remove_prefix(end + 1);
    }
}

/// "a", "a or b", "a, b or c".
inline std::string either_of(std::span<const std::string> texts) {
    if (texts.size() < 2) return joined(texts, "");
    return joined(texts.first(texts.size() - 1), ", ") + " or " + texts.back();
}

}  // namespace interleaf
