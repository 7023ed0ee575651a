// Bytes as text: base64, as RFC 4648 describes it, with padding.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace interleaf {

std::string to_base64(std::string_view bytes);

/// The bytes that \p text stands for, with or without padding; none if a character is not base64.
std::optional<std::string> from_base64(std::string_view text);

}  // namespace interleaf
