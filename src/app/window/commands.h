// The table of commands: shortcuts, menus and help all come from it.
#pragma once

#include <array>
#include <cstdint>
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

/// In the order of the table.
enum class CommandId : std::uint8_t {
    open,
    reopen,
    save,
    save_as,
    quit,
    undo,
    redo,
    rename_family,
    new_domain,
    edit_domain,
    add_keys,
    keep_blend,
    rename_key,
    duplicate_key,
    put_on_timeline,
    move_key_up,
    move_key_down,
    remove_key,
    play,
    loop,
    go_to_start,
    go_to_end,
    step_back,
    step_forward,
    go_to_previous_key,
    go_to_next_key,
    frame_model,
    smooth_shading,
    wireframe,
    refinement_edges,
    root_edges,
    next_coloring,
    compare_with_mesh,
    reload_shaders,
    help,
    dismiss,
};

/// What a command is about, and so when it is available.
enum class CommandScope : std::uint8_t {
    window,        ///< the window or its files: always
    document,      ///< the document: while the window shows it, not a comparison
    selected_key,  ///< the selected key of the document: while the window shows it and a key is selected
};

struct Command {
    CommandId id;
    CommandScope scope = CommandScope::window;
    std::string_view menu;
    std::string_view name;
    std::array<Shortcut, 2> shortcuts;
    std::string_view description;
    void (*run)(ViewerState& state, double now);
    bool repeats = false;                                      ///< while its shortcut is held down
    bool (*is_on)(const ViewerState& state) = nullptr;         ///< null for a command that is no switch
    bool (*is_possible)(const ViewerState& state) = nullptr;   ///< null where the scope alone decides
    std::string (*label)(const ViewerState& state) = nullptr;  ///< name in the menu; null for the fixed name
};

/// All commands; the commands of one menu stand in a row.
std::span<const Command> commands();

const Command& command_of(CommandId id);

/// \return the command with \p shortcut; null when there is none
const Command* find_command(Shortcut shortcut);

/// Runs \p command if it is enabled.
void run_command(const Command& command, ViewerState& state, double now);
void run_command(CommandId id, ViewerState& state, double now);

/// Whether \p command's scope and its own condition allow it now.
bool is_enabled(const Command& command, const ViewerState& state);
bool is_enabled(CommandId id, const ViewerState& state);

/// "Ctrl+Q", "W or 1"; empty for none.
std::string shortcut_text(const Command& command);

}  // namespace interleaf
