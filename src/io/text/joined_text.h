// Joins texts with a separator between them.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace interleaf {

inline std::string joined(std::span<const std::string> texts, std::string_view separator) {
    std::string result;
    for (const std::string& text : texts) {
        if (!result.empty()) result += separator;
        result += text;
    }
    return result;
}

/// "a", "a or b", "a, b or c".
inline std::string either_of(std::span<const std::string> texts) {
    if (texts.size() < 2) return joined(texts, "");
    return joined(texts.first(texts.size() - 1), ", ") + " or " + texts.back();
}

}  // namespace interleaf
