// The files of the web page, compiled into the library. The build writes the source (embed_page.cmake).
#pragma once

#include <span>
#include <string_view>

namespace interleaf {

struct EmbeddedPart {
    std::string_view name;  ///< "page.css" or "script"; with " hash" behind it for the SHA-256 in base64
    std::string_view text;
};

std::span<const EmbeddedPart> embedded_page();

}  // namespace interleaf
