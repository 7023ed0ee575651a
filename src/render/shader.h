// Shader programs from the GLSL files in shaders/. During development they are read from that folder; a
// program without the folder uses embedded copies.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "render/gl_object.h"

namespace interleaf {

/// The text of shaders/\p file: from disk if the folder exists, otherwise as embedded at build time.
/// \throw InputError if there is no such file
std::string shader_source(std::string_view file);

/// Compiles and links \p files.
/// \param files        their extensions (.vert, .geom, .frag) tell the stage of each
/// \param definitions  lines of GLSL to insert behind the #version line of each file
/// \pre  a context is current
/// \throw InputError with the compiler's message, which names file and line
GlProgram link_program(std::span<const std::string_view> files, std::string_view definitions = {});

/// The compiler's \p log with "file:line" for each line reference. Drivers write these references in
/// different ways.
std::string name_lines(std::string_view log, std::string_view file);

}  // namespace interleaf
