// The table of commands. Shortcuts, menus and help come from it.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "app/document/viewer_state.h"

namespace interleaf {

/// A key of the keyboard, with modifier bits GLFW_MOD_CONTROL, GLFW_MOD_SHIFT and GLFW_MOD_ALT.
struct Shortcut {
    int keyboard_key = 0;  ///< GLFW's number of the key; 0 for none
    int modifiers = 0;
    bool operator==(const Shortcut&) const = default;
};

/// In the order of the table.
enum class CommandId : std::uint8_t {
    open,
    import_series,
    reopen,
    save,
    save_as,
    export_as,
    save_picture,
    quit,
    undo,
    redo,
    rename_family,
    set_field_unit,
    set_time_unit,
    new_domain,
    edit_domain,
    add_keys,
    set_landmarks,
    keep_blend,
    refine_brush,
    rename_key,
    duplicate_key,
    put_on_timeline,
    add_present_time,
    put_in_domain,
    take_out_of_domain,
    move_key_up,
    move_key_down,
    remove_key,
    play,
    play_backward,
    next_repeat,
    go_to_start,
    go_to_end,
    step_back,
    step_forward,
    go_to_previous_key,
    go_to_next_key,
    go_to_time,
    slower,
    faster,
    normal_speed,
    set_speed,
    set_frame_rate,
    set_in,
    set_out,
    play_all,
    next_interpolation,
    bernstein_pieces,
    remove_present_time,
    record_path,
    follow_path,
    smooth_path,
    remove_path,
    show_all_times,
    go_to_place,
    use_arrows_in_domain,
    inspect_leaf,
    go_to_parent,
    go_to_sibling,
    go_to_first_child,
    go_to_second_child,
    cross_refinement_edge,
    cross_second_edge,
    cross_third_edge,
    drive_by_timeline,
    drive_by_domain,
    show_one_key,
    drive_by_weights,
    turn_parts,
    sum_to_one,
    reset_weights,
    frame_model,
    view_front,
    view_back,
    view_left,
    view_right,
    view_top,
    view_bottom,
    usual_view,
    orthographic,
    x_up,
    y_up,
    z_up,
    trackball,
    spin,
    turn_left,
    turn_right,
    turn_up,
    turn_down,
    roll_left,
    roll_right,
    zoom_in,
    zoom_out,
    show_axes,
    copy_view,
    paste_view,
    copy_command,
    show_whole_domain,
    smooth_shading,
    ambient_occlusion,
    ground,
    next_material,
    wireframe,
    refinement_edges,
    root_edges,
    vertices,
    normals,
    next_coloring,
    less_detail,
    more_detail,
    follow_camera,
    keys_beside,
    plot_blend,
    compare_with_mesh,
    reload_shaders,
    light_theme,
    larger_text,
    smaller_text,
    usual_look,
    open_menu,
    next_panel,
    previous_panel,
    search_commands,
    find,
    help,
    dismiss,
};

/// The object that a command acts on. It determines when the command is available.
enum class CommandScope : std::uint8_t {
    window,        ///< the window or its files: always available
    document,      ///< the document: available while the window shows it instead of a comparison
    selected_key,  ///< the selected key: as `document`, while a key is selected
};

struct Command {
    CommandId id;
    CommandScope scope = CommandScope::window;
    std::string_view menu;
    std::string_view name;
    std::array<Shortcut, 2> shortcuts;
    std::string_view description;
    void (*run)(ViewerState& state, double now);
    bool repeats = false;  ///< whether the command repeats while its shortcut is held down
    bool (*is_on)(const ViewerState& state) = nullptr;         ///< null for a command that does not toggle
    bool (*is_possible)(const ViewerState& state) = nullptr;   ///< null where the scope alone decides
    std::string (*label)(const ViewerState& state) = nullptr;  ///< name in the menu; null for the fixed name
};

/// All commands. The commands of one menu are consecutive.
std::span<const Command> commands();

const Command& command_of(CommandId id);

/// Runs \p command if it is enabled.
void run_command(const Command& command, ViewerState& state, double now);
void run_command(CommandId id, ViewerState& state, double now);

/// Whether the scope of \p command and its own condition allow the command now.
bool is_enabled(const Command& command, const ViewerState& state);
bool is_enabled(CommandId id, const ViewerState& state);

/// Why \p command is not enabled, "select a key first"; empty if it is enabled.
std::string_view obstacle_of(const Command& command, const ViewerState& state);

/// \p shortcut as text, "Ctrl+Q".
std::string shortcut_text(Shortcut shortcut);

/// The shortcut in \p text, in any case; none if \p text is no shortcut.
std::optional<Shortcut> parse_shortcut(std::string_view text);

}  // namespace interleaf
