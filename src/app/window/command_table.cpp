// The table of commands, and the functions that they run.
#include "app/window/commands.h"

// GLFW must not include OpenGL headers of its own.
#define GLFW_INCLUDE_NONE

#include <iterator>

#include <GLFW/glfw3.h>
#include <fmt/core.h>

#include "app/document/edit_commands.h"

namespace interleaf {

namespace {

/// Step of the arrow keys, as a fraction of the timeline's duration.
constexpr double step_part = 0.01;

void step(ViewerState& state, double direction, double now) {
    Session& session = state.session;
    if (!session.has_timeline()) return;
    const Timeline& timeline = *session.family().timeline;
    session.seek(session.time() + direction * step_part * (timeline.end() - timeline.begin()), now);
}

void cycle_coloring(ViewerState& state, double) {
    if (state.is_comparing) {
        state.compares_colors = !state.compares_colors;
        return;
    }
    Display& display = state.session.display;
    display.coloring = next_coloring(display.coloring, !display.field.empty());
}

void toggle_shading(ViewerState& state, double) {
    Shading& shading = state.session.display.shading;
    shading = shading == Shading::smooth ? Shading::flat : Shading::smooth;
}

template <bool Display::*line>
void toggle(ViewerState& state, double) {
    state.session.display.*line = !(state.session.display.*line);
}

template <bool Display::*line>
bool is_on(const ViewerState& state) {
    return state.session.display.*line;
}

template <FileWish wish>
void wish_for(ViewerState& state, double) {
    state.file_wish = wish;
}

bool has_domain(const ViewerState& state) {
    return state.document.family().domain.has_value();
}

bool can_compare(const ViewerState& state) {
    return !compared_keys(state.document.family(), state.comparisons).empty();
}

/// Shows or hides the comparison. It begins with the selected key, if that key has a comparison.
void toggle_comparison(ViewerState& state, double) {
    state.is_comparing = !state.is_comparing;
    if (!state.is_comparing) return;
    state.message.clear();  // the message would cover the comparison
    if (!state.selected_key) return;
    for (const ComparedKey& each : compared_keys(state.document.family(), state.comparisons))
        if (each.key == *state.selected_key) state.compared = each.comparison;
}

std::string step_label(const char* command, const std::string* step) {
    return step != nullptr ? fmt::format("{} {}", command, *step) : command;
}

constexpr Command table[] = {
    {.id = CommandId::open,
     .menu = "File",
     .name = "Open",
     .shortcuts = {{{GLFW_KEY_O, GLFW_MOD_CONTROL}}},
     .description = "Open a family, keys or meshes (or drop files on the picture)",
     .run = wish_for<FileWish::open>},
    {.id = CommandId::reopen,
     .menu = "File",
     .name = "Reopen",
     .shortcuts = {{{GLFW_KEY_R, GLFW_MOD_CONTROL}}},
     .description = "Read the open files again",
     .run = wish_for<FileWish::reopen>},
    {.id = CommandId::save,
     .menu = "File",
     .name = "Save",
     .shortcuts = {{{GLFW_KEY_S, GLFW_MOD_CONTROL}}},
     .description = "Save the family in its folder",
     .run = wish_for<FileWish::save>},
    {.id = CommandId::save_as,
     .menu = "File",
     .name = "Save as",
     .shortcuts = {{{GLFW_KEY_S, GLFW_MOD_CONTROL | GLFW_MOD_SHIFT}}},
     .description = "Save the family in another folder",
     .run = wish_for<FileWish::save_as>},
    {.id = CommandId::quit,
     .menu = "File",
     .name = "Quit",
     .shortcuts = {{{GLFW_KEY_Q, GLFW_MOD_CONTROL}}},
     .description = "Close the window",
     .run = wish_for<FileWish::quit>},

    {.id = CommandId::undo,
     .scope = CommandScope::document,
     .menu = "Edit",
     .name = "Undo",
     .shortcuts = {{{GLFW_KEY_Z, GLFW_MOD_CONTROL}}},
     .description = "Undo the last edit",
     .run = undo,
     .repeats = true,
     .is_possible = [](const ViewerState& state) { return state.document.undo_step() != nullptr; },
     .label = [](const ViewerState& state) { return step_label("Undo", state.document.undo_step()); }},
    {.id = CommandId::redo,
     .scope = CommandScope::document,
     .menu = "Edit",
     .name = "Redo",
     .shortcuts = {{{GLFW_KEY_Z, GLFW_MOD_CONTROL | GLFW_MOD_SHIFT}, {GLFW_KEY_Y, GLFW_MOD_CONTROL}}},
     .description = "Redo the last edit that was undone",
     .run = redo,
     .repeats = true,
     .is_possible = [](const ViewerState& state) { return state.document.redo_step() != nullptr; },
     .label = [](const ViewerState& state) { return step_label("Redo", state.document.redo_step()); }},
    {.id = CommandId::rename_family,
     .scope = CommandScope::document,
     .menu = "Edit",
     .name = "Rename family",
     .shortcuts = {{{GLFW_KEY_F2, GLFW_MOD_SHIFT}}},
     .description = "Give the family another name",
     .run = [](ViewerState& state, double) { ask_for_family_name(state); }},
    {.id = CommandId::new_domain,
     .scope = CommandScope::document,
     .menu = "Edit",
     .name = "New domain",
     .shortcuts = {{{GLFW_KEY_N, GLFW_MOD_CONTROL}}},
     .description = "Make a parameter domain of all keys: a triangle, or a polygon about the first key",
     .run = make_domain},
    {.id = CommandId::edit_domain,
     .scope = CommandScope::document,
     .menu = "Edit",
     .name = "Edit domain",
     .shortcuts = {{{GLFW_KEY_D}}},
     .description = "Drag the vertices of the parameter domain instead of the point",
     .run = [](ViewerState& state, double) { state.edits_domain = !state.edits_domain; },
     .is_on = [](const ViewerState& state) { return state.edits_domain; },
     .is_possible = has_domain},

    {.id = CommandId::add_keys,
     .scope = CommandScope::document,
     .menu = "Key",
     .name = "Add keys",
     .shortcuts = {{{GLFW_KEY_I, GLFW_MOD_CONTROL}}},
     .description = "Add keys or meshes from files (or drop files on the list of keys)",
     .run = wish_for<FileWish::add_keys>},
    {.id = CommandId::keep_blend,
     .scope = CommandScope::document,
     .menu = "Key",
     .name = "Keep blend",
     .shortcuts = {{{GLFW_KEY_K, GLFW_MOD_CONTROL}}},
     .description = "Add the surface that is shown as a key",
     .run = keep_blend},
    {.id = CommandId::rename_key,
     .scope = CommandScope::selected_key,
     .menu = "Key",
     .name = "Rename key",
     .shortcuts = {{{GLFW_KEY_F2}}},
     .description = "Give the selected key another name",
     .run = [](ViewerState& state, double) { ask_for_key_name(state); }},
    {.id = CommandId::duplicate_key,
     .scope = CommandScope::selected_key,
     .menu = "Key",
     .name = "Duplicate key",
     .shortcuts = {{{GLFW_KEY_D, GLFW_MOD_CONTROL}}},
     .description = "Add a second key with the surface of the selected key",
     .run = duplicate_key},
    {.id = CommandId::put_on_timeline,
     .scope = CommandScope::selected_key,
     .menu = "Key",
     .name = "Put on timeline",
     .shortcuts = {{{GLFW_KEY_T}}},
     .description = "Put the selected key on the timeline (or drag it there)",
     .run = [](ViewerState& state, double) { ask_for_new_time(state); }},
    {.id = CommandId::move_key_up,
     .scope = CommandScope::selected_key,
     .menu = "Key",
     .name = "Move key up",
     .shortcuts = {{{GLFW_KEY_UP, GLFW_MOD_ALT}}},
     .description = "Move the selected key up in the list (or drag it)",
     .run =
         [](ViewerState& state, double now) {
             if (state.selected_key.value_or(0) > 0) move_key(state, *state.selected_key - 1, now);
         },
     .repeats = true},
    {.id = CommandId::move_key_down,
     .scope = CommandScope::selected_key,
     .menu = "Key",
     .name = "Move key down",
     .shortcuts = {{{GLFW_KEY_DOWN, GLFW_MOD_ALT}}},
     .description = "Move the selected key down in the list",
     .run =
         [](ViewerState& state, double now) {
             if (state.selected_key) move_key(state, *state.selected_key + 1, now);
         },
     .repeats = true},
    {.id = CommandId::remove_key,
     .scope = CommandScope::selected_key,
     .menu = "Key",
     .name = "Remove key",
     .shortcuts = {{{GLFW_KEY_DELETE}}},
     .description = "Remove the selected key, also from timeline and domain",
     .run = remove_key},

    {.id = CommandId::play,
     .scope = CommandScope::document,
     .menu = "Playback",
     .name = "Play",
     .shortcuts = {{{GLFW_KEY_SPACE}}},
     .description = "Play or pause; the surface follows the timeline again",
     .run = [](ViewerState& state, double now) { state.session.toggle_playing(now); },
     .is_on = [](const ViewerState& state) { return state.session.is_playing(); }},
    {.id = CommandId::loop,
     .scope = CommandScope::document,
     .menu = "Playback",
     .name = "Loop",
     .shortcuts = {{{GLFW_KEY_L}}},
     .description = "Start over at the end",
     .run = [](ViewerState& state, double now) { state.session.toggle_loop(now); },
     .is_on = [](const ViewerState& state) { return state.session.loops(); }},
    {.id = CommandId::go_to_start,
     .scope = CommandScope::document,
     .menu = "Playback",
     .name = "Go to start",
     .shortcuts = {{{GLFW_KEY_HOME}}},
     .description = "Go to the start of the timeline",
     .run =
         [](ViewerState& state, double now) {
             if (state.session.has_timeline())
                 state.session.seek(state.session.family().timeline->begin(), now);
         }},
    {.id = CommandId::go_to_end,
     .scope = CommandScope::document,
     .menu = "Playback",
     .name = "Go to end",
     .shortcuts = {{{GLFW_KEY_END}}},
     .description = "Go to the end of the timeline",
     .run =
         [](ViewerState& state, double now) {
             if (state.session.has_timeline())
                 state.session.seek(state.session.family().timeline->end(), now);
         }},
    {.id = CommandId::step_back,
     .scope = CommandScope::document,
     .menu = "Playback",
     .name = "Step back",
     .shortcuts = {{{GLFW_KEY_LEFT}}},
     .description = "Go back by a hundredth of the timeline",
     .run = [](ViewerState& state, double now) { step(state, -1, now); },
     .repeats = true},
    {.id = CommandId::step_forward,
     .scope = CommandScope::document,
     .menu = "Playback",
     .name = "Step forward",
     .shortcuts = {{{GLFW_KEY_RIGHT}}},
     .description = "Go forward by a hundredth of the timeline",
     .run = [](ViewerState& state, double now) { step(state, 1, now); },
     .repeats = true},
    {.id = CommandId::go_to_previous_key,
     .scope = CommandScope::document,
     .menu = "Playback",
     .name = "Go to previous key",
     .shortcuts = {{{GLFW_KEY_LEFT, GLFW_MOD_CONTROL}, {GLFW_KEY_PAGE_UP}}},
     .description = "Go to the previous key on the timeline",
     .run = [](ViewerState& state, double now) { state.session.seek_key(-1, now); }},
    {.id = CommandId::go_to_next_key,
     .scope = CommandScope::document,
     .menu = "Playback",
     .name = "Go to next key",
     .shortcuts = {{{GLFW_KEY_RIGHT, GLFW_MOD_CONTROL}, {GLFW_KEY_PAGE_DOWN}}},
     .description = "Go to the next key on the timeline",
     .run = [](ViewerState& state, double now) { state.session.seek_key(1, now); }},

    {.id = CommandId::frame_model,
     .menu = "View",
     .name = "Frame model",
     .shortcuts = {{{GLFW_KEY_F}}},
     .description = "See the whole surface that is shown (or double-click it)",
     .run = [](ViewerState& state, double) { state.view_target = ViewTarget::surface; }},
    {.id = CommandId::smooth_shading,
     .menu = "View",
     .name = "Smooth shading",
     .shortcuts = {{{GLFW_KEY_S}}},
     .description = "Shade smoothly, or each triangle flat",
     .run = toggle_shading,
     .is_on = [](const ViewerState& state) { return state.session.display.shading == Shading::smooth; }},
    {.id = CommandId::wireframe,
     .menu = "View",
     .name = "Wireframe",
     .shortcuts = {{{GLFW_KEY_W}, {GLFW_KEY_1}}},
     .description = "Show the edges of the leaves",
     .run = toggle<&Display::wireframe>,
     .is_on = is_on<&Display::wireframe>},
    {.id = CommandId::refinement_edges,
     .menu = "View",
     .name = "Refinement edges",
     .shortcuts = {{{GLFW_KEY_R}, {GLFW_KEY_2}}},
     .description = "Show the edge that bisection would split next",
     .run = toggle<&Display::refinement_edges>,
     .is_on = is_on<&Display::refinement_edges>},
    {.id = CommandId::root_edges,
     .menu = "View",
     .name = "Root edges",
     .shortcuts = {{{GLFW_KEY_E}, {GLFW_KEY_3}}},
     .description = "Show the edges of the root complex",
     .run = toggle<&Display::root_edges>,
     .is_on = is_on<&Display::root_edges>},
    {.id = CommandId::next_coloring,
     .menu = "View",
     .name = "Next coloring",
     .shortcuts = {{{GLFW_KEY_C}}},
     .description = "Color plainly, by level, by origin, as a checkerboard, by field",
     .run = cycle_coloring},
    {.id = CommandId::compare_with_mesh,
     .menu = "View",
     .name = "Compare with mesh",
     .shortcuts = {{{GLFW_KEY_M}}},
     .description = "See fitted keys beside their meshes, with the distances",
     .run = toggle_comparison,
     .is_on = [](const ViewerState& state) { return state.is_comparing; },
     .is_possible = can_compare},
    {.id = CommandId::reload_shaders,
     .menu = "View",
     .name = "Reload shaders",
     .shortcuts = {{{GLFW_KEY_F5}}},
     .description = "Read the shader files again",
     .run = [](ViewerState& state, double) { state.reload_wanted = true; }},

    {.id = CommandId::help,
     .menu = "Help",
     .name = "Keys and mouse",
     .shortcuts = {{{GLFW_KEY_F1}, {GLFW_KEY_H}}},
     .description = "Show or hide this help",
     .run = [](ViewerState& state, double) { state.help_shown = !state.help_shown; },
     .is_on = [](const ViewerState& state) { return state.help_shown; }},
    {.id = CommandId::dismiss,
     .menu = "Help",
     .name = "Dismiss",
     .shortcuts = {{{GLFW_KEY_ESCAPE}}},
     .description = "Close the message, the help or the comparison",
     .run =
         [](ViewerState& state, double) {
             if (!state.message.empty())
                 state.message.clear();
             else if (state.help_shown)
                 state.help_shown = false;
             else
                 state.is_comparing = false;
         }},
};

/// Whether the commands are in the order of their ids.
consteval bool is_in_order_of_ids() {
    for (std::size_t place = 0; place < std::size(table); ++place)
        if (static_cast<std::size_t>(table[place].id) != place) return false;
    return static_cast<std::size_t>(CommandId::dismiss) + 1 == std::size(table);
}
static_assert(is_in_order_of_ids());

}  // namespace

std::span<const Command> commands() {
    return table;
}

}  // namespace interleaf
