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

}  // namespace interleaf
