// The command line that draws what the window shows: `interleaf render` with all its options.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec2.hpp>

#include "app/document/session.h"
#include "app/document/viewpoint.h"
#include "render/display.h"

namespace interleaf {

/// The options of `render` that differ from their defaults in \p display, each "--NAME" or
/// "--NAME=VALUE".
std::vector<std::string> display_options(const Display& display);

/// The options of `render` and `view` for the height and the arrows that \p display gives the family of \p session.
std::vector<std::string> field_options(const Session& session, const Display& display);

/// The option that chooses the blend of \p session: --time, --at or --weights.
std::string blend_option(const Session& session);

/// \p text as one word of a POSIX shell.
std::string command_word(std::string_view text);

/// The whole line.
/// \param files      of the family; empty for the built-in one
/// \param viewpoint  with center and distance
/// \param size       of the picture, pixels
std::string picture_command(std::span<const std::filesystem::path> files, const Session& session,
                            const Display& display, const Viewpoint& viewpoint, glm::ivec2 size);

}  // namespace interleaf
