// What tests ask of messages.
#pragma once

#include <algorithm>
#include <span>
#include <string>
#include <string_view>

namespace interleaf {

inline bool contains(std::string_view text, std::string_view part) {
    return text.find(part) != std::string_view::npos;
}

/// Whether one of \p texts contains \p part.
inline bool mentions(std::span<const std::string> texts, std::string_view part) {
    return std::ranges::any_of(texts, [&](const std::string& text) { return contains(text, part); });
}

}  // namespace interleaf
