// Shader programs from the GLSL files in shaders/. In development they are read from that folder; a program
// without it has them embedded.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "render/gl_object.h"

namespace interleaf {

/// The text of shaders/\p file: from disk where the folder exists, otherwise as embedded at build time.
/// \throw InputError if there is no such file
std::string shader_source(std::string_view file);

/// Compiles and links \p files; their endings (.vert, .geom, .frag) say which stage each is. \p definitions
/// are lines of GLSL that go behind the #version line of each. \pre  a context is current \throw InputError
/// with the compiler's message, which names file and line
GlProgram link_program(std::span<const std::string_view> files, std::string_view definitions = {});

/// The compiler's \p log with its way of naming a line, which differs from driver to driver, replaced by
/// "file:line".
std::string name_lines(std::string_view log, std::string_view file);

}  // namespace interleaf
