// The files of the web page, compiled into the library. The build writes the source (embed_page.cmake).
#pragma once

#include <span>
#include <string_view>

namespace interleaf {

struct EmbeddedPart {
    std::string_view name;  ///< "page.js"; "page.js hash" for the SHA-256 of that file in base64
    std::string_view text;
};

std::span<const EmbeddedPart> embedded_page();

}  // namespace interleaf
