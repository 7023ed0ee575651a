// The shader files as of build time; embed_shaders.cmake writes the definition.
#pragma once

#include <span>
#include <string_view>

namespace interleaf {

struct EmbeddedShader {
    std::string_view file;
    std::string_view source;
};

std::span<const EmbeddedShader> embedded_shaders();

}  // namespace interleaf
