// The events that a GLFW window receives.
#pragma once

#include <filesystem>
#include <span>
#include <vector>

#include "app/window/commands.h"
#include "app/window/shortcuts.h"
#include "ui/widgets/rect.h"

struct GLFWwindow;

namespace interleaf {

/// The events since the last frame. The callbacks add to them.
struct WindowInput {
    std::vector<int> keyboard_keys;  ///< pressed, each after its modifiers, as GLFW numbers them
    std::vector<Shortcut> pressed;
    std::vector<std::filesystem::path> dropped;
    bool is_alt_alone = false;  ///< Alt is down, and nothing else has been pressed since
    Shortcuts shortcuts{};      ///< only these are collected in `pressed`
};

/// Installs the callbacks that add to \p input. Call this function before Dear ImGui installs its callbacks,
/// which pass events on to those installed before.
/// \param input  must outlive \p window
/// \return       \p window
GLFWwindow* watch_input(GLFWwindow* window, WindowInput& input);

/// Whether the pointer is over \p rect, in screen coordinates of \p window.
bool is_pointer_over(const Rect& rect, GLFWwindow* window);

/// Whether a panel that has the keyboard reads \p shortcut: to move in it, to press, and to leave it.
bool belongs_to_panel(Shortcut shortcut);

/// Whether the parameter domain reads \p shortcut, because it has the arrow keys.
bool belongs_to_domain(Shortcut shortcut, const ViewerState& state);

/// Whether the brush reads \p shortcut: [ and ], while it is in use.
bool belongs_to_brush(Shortcut shortcut, const ViewerState& state);

/// Runs the commands of \p pressed in their order, while nothing is asked and no menu or search field is to open: what
/// is pressed after that is not for the document. During a slow frame, many keys are pressed.
/// \return the other shortcuts, for the next frame
std::vector<Shortcut> run_pressed(std::span<const Shortcut> pressed, const Shortcuts& shortcuts,
                                  ViewerState& state, double now);

}  // namespace interleaf
