// The one table of commands, from which the keys, the menus and the help come.
#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>

#include "app/document/viewer_state.h"

namespace interleaf {

/// A key of the keyboard with GLFW_MOD_CONTROL, _SHIFT and _ALT bits.
struct Shortcut {
    int keyboard_key = 0;  ///< as GLFW numbers it; 0 for none
    int modifiers = 0;
    bool operator==(const Shortcut&) const = default;
};

struct Command {
    std::string_view menu;
    std::string_view name;
    std::array<Shortcut, 2> shortcuts;
    std::string_view description;
    void (*run)(ViewerState& state, double now);
    bool (*is_on)(const ViewerState& state) = nullptr;         ///< for what can be on or off
    bool repeats = false;                                      ///< while its key is held
    bool (*is_enabled)(const ViewerState& state) = nullptr;    ///< for what cannot be done always
    std::string (*label)(const ViewerState& state) = nullptr;  ///< what it is called now, in the menu
};

/// All commands, those of one menu in a row.
std::span<const Command> commands();

/// The command of a shortcut; null when there is none.
const Command* find_command(Shortcut shortcut);

/// Runs \p command where it is enabled.
void run_command(const Command& command, ViewerState& state, double now);

bool is_enabled(const Command& command, const ViewerState& state);

/// The command called \p name.
/// \pre  there is one
const Command& command_named(std::string_view name);

/// "Ctrl+Q", "W or 1"; empty for none.
std::string shortcut_text(const Command& command);

}  // namespace interleaf
