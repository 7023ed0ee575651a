// Files dragged from another program and dropped on a window: the source's side of the XDND protocol, version
// 5, https://freedesktop.org/wiki/Specifications/XDND.
#pragma once

#include <filesystem>
#include <span>

#include "e2e/desktop.h"
#include <glm/vec2.hpp>

namespace interleaf {

/// Drops \p files on \p window, and returns when the window has taken them.
/// \param at  a pixel of the window
/// \throw std::runtime_error if the window does not take them within a minute
void drop_files(WindowName window, glm::ivec2 at, std::span<const std::filesystem::path> files);

}  // namespace interleaf
