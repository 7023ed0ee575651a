// What comes from outside to a window of GLFW.
#pragma once

#include <filesystem>
#include <vector>

#include "app/window/commands.h"

struct GLFWwindow;

namespace interleaf {

/// What has come from outside since the last frame; callbacks add to it.
struct WindowInput {
    std::vector<int> keyboard_keys;  ///< pressed, each after its modifiers, as GLFW numbers them
    std::vector<Shortcut> pressed;
    std::vector<std::filesystem::path> dropped;
};

/// Installs the callbacks that add to \p input, which must outlive the window. Before Dear ImGui's own, which
/// pass events on. \return \p window
GLFWwindow* watch_input(GLFWwindow* window, WindowInput& input);

}  // namespace interleaf
