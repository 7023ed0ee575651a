// The events that a GLFW window receives.
#pragma once

#include <filesystem>
#include <vector>

#include "app/window/commands.h"

struct GLFWwindow;

namespace interleaf {

/// The events since the last frame. The callbacks add to them.
struct WindowInput {
    std::vector<int> keyboard_keys;  ///< pressed, each after its modifiers, as GLFW numbers them
    std::vector<Shortcut> pressed;
    std::vector<std::filesystem::path> dropped;
};

/// Installs the callbacks that add to \p input. Call this function before Dear ImGui installs its callbacks,
/// which pass events on to those installed before.
/// \param input  must outlive \p window
/// \return       \p window
GLFWwindow* watch_input(GLFWwindow* window, WindowInput& input);

/// Whether the parameter domain reads \p shortcut, because it has the arrow keys.
bool belongs_to_domain(Shortcut shortcut, const ViewerState& state);

/// Whether the brush reads \p shortcut: [ and ], while it is in use.
bool belongs_to_brush(Shortcut shortcut, const ViewerState& state);

}  // namespace interleaf
