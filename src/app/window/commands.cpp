#include "app/window/commands.h"

// GLFW must not bring OpenGL headers of its own.
#define GLFW_INCLUDE_NONE

#include <algorithm>
#include <cassert>

#include <GLFW/glfw3.h>
#include <fmt/core.h>

#include "app/document/edit_commands.h"

namespace interleaf {

namespace {

/// The arrows' step, as a part of the whole timeline.
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

bool has_selected_key(const ViewerState& state) {
    return state.selected_key.has_value();
}

bool has_domain(const ViewerState& state) {
    return state.document.family().domain.has_value();
}

bool can_compare(const ViewerState& state) {
    return !compared_keys(state.document.family(), state.comparisons).empty();
}

/// The key that is selected comes first.
void toggle_comparison(ViewerState& state, double) {
    state.is_comparing = !state.is_comparing;
    if (!state.is_comparing) return;
    state.message.clear();  // it would lie over what is compared
    if (!state.selected_key) return;
    for (const ComparedKey& each : compared_keys(state.document.family(), state.comparisons))
        if (each.key == *state.selected_key) state.compared = each.comparison;
}

/// What is not to be done while the document is not to be seen.
bool is_about_document(const Command& command) {
    return command.menu == "Edit" || command.menu == "Key" || command.menu == "Playback";
}

std::string step_label(const char* command, const std::string* step) {
    return step != nullptr ? fmt::format("{} {}", command, *step) : command;
}

constexpr Command table[] = {
    {"File",
     "Open",
     {{{GLFW_KEY_O, GLFW_MOD_CONTROL}}},
     "Open a family, keys or meshes (or drop files on the picture)",
     wish_for<FileWish::open>},
    {"File",
     "Reopen",
     {{{GLFW_KEY_R, GLFW_MOD_CONTROL}}},
     "Read the open files again",
     wish_for<FileWish::reopen>},
    {"File",
     "Save",
     {{{GLFW_KEY_S, GLFW_MOD_CONTROL}}},
     "Save the family in its folder",
     wish_for<FileWish::save>},
    {"File",
     "Save as",
     {{{GLFW_KEY_S, GLFW_MOD_CONTROL | GLFW_MOD_SHIFT}}},
     "Save the family in another folder",
     wish_for<FileWish::save_as>},
    {"File", "Quit", {{{GLFW_KEY_Q, GLFW_MOD_CONTROL}}}, "Close the window", wish_for<FileWish::quit>},

    {"Edit",
     "Undo",
     {{{GLFW_KEY_Z, GLFW_MOD_CONTROL}}},
     "Take the last edit back",
     undo,
     nullptr,
     true,
     [](const ViewerState& state) { return state.document.undo_step() != nullptr; },
     [](const ViewerState& state) { return step_label("Undo", state.document.undo_step()); }},
    {"Edit",
     "Redo",
     {{{GLFW_KEY_Z, GLFW_MOD_CONTROL | GLFW_MOD_SHIFT}, {GLFW_KEY_Y, GLFW_MOD_CONTROL}}},
     "Do what was undone again",
     redo,
     nullptr,
     true,
     [](const ViewerState& state) { return state.document.redo_step() != nullptr; },
     [](const ViewerState& state) { return step_label("Redo", state.document.redo_step()); }},
    {"Edit",
     "Rename family",
     {{{GLFW_KEY_F2, GLFW_MOD_SHIFT}}},
     "Give the family another name",
     [](ViewerState& state, double) { ask_for_family_name(state); }},
    {"Edit",
     "New domain",
     {{{GLFW_KEY_N, GLFW_MOD_CONTROL}}},
     "Make a parameter domain of all keys: a triangle, or a polygon about the first key",
     make_domain},
    {"Edit",
     "Edit domain",
     {{{GLFW_KEY_D}}},
     "Drag the vertices of the parameter domain instead of the point",
     [](ViewerState& state, double) { state.edits_domain = !state.edits_domain; },
     [](const ViewerState& state) { return state.edits_domain; },
     false,
     has_domain},

    {"Key",
     "Add keys",
     {{{GLFW_KEY_I, GLFW_MOD_CONTROL}}},
     "Add keys or meshes from files (or drop files on the list of keys)",
     wish_for<FileWish::add_keys>},
    {"Key",
     "Keep blend",
     {{{GLFW_KEY_K, GLFW_MOD_CONTROL}}},
     "Make the surface that is shown a key",
     keep_blend},
    {"Key",
     "Rename key",
     {{{GLFW_KEY_F2}}},
     "Give the selected key another name",
     [](ViewerState& state, double) { ask_for_key_name(state); },
     nullptr,
     false,
     has_selected_key},
    {"Key",
     "Duplicate key",
     {{{GLFW_KEY_D, GLFW_MOD_CONTROL}}},
     "Make a second key of the selected one's surface",
     duplicate_key,
     nullptr,
     false,
     has_selected_key},
    {"Key",
     "Put on timeline",
     {{{GLFW_KEY_T}}},
     "Put the selected key on the timeline (or drag it there)",
     [](ViewerState& state, double) { ask_for_new_time(state); },
     nullptr,
     false,
     has_selected_key},
    {"Key",
     "Move key up",
     {{{GLFW_KEY_UP, GLFW_MOD_ALT}}},
     "Move the selected key up in the list (or drag it)",
     [](ViewerState& state, double now) {
         if (state.selected_key.value_or(0) > 0) move_key(state, *state.selected_key - 1, now);
     },
     nullptr,
     true,
     has_selected_key},
    {"Key",
     "Move key down",
     {{{GLFW_KEY_DOWN, GLFW_MOD_ALT}}},
     "Move the selected key down in the list",
     [](ViewerState& state, double now) {
         if (state.selected_key) move_key(state, *state.selected_key + 1, now);
     },
     nullptr,
     true,
     has_selected_key},
    {"Key",
     "Remove key",
     {{{GLFW_KEY_DELETE}}},
     "Remove the selected key, also from timeline and domain",
     remove_key,
     nullptr,
     false,
     has_selected_key},

    {"Playback",
     "Play",
     {{{GLFW_KEY_SPACE}}},
     "Play or pause; the surface follows the timeline again",
     [](ViewerState& state, double now) { state.session.toggle_playing(now); },
     [](const ViewerState& state) { return state.session.is_playing(); }},
    {"Playback",
     "Loop",
     {{{GLFW_KEY_L}}},
     "Start over at the end",
     [](ViewerState& state, double now) { state.session.toggle_loop(now); },
     [](const ViewerState& state) { return state.session.loops(); }},
    {"Playback",
     "Begin",
     {{{GLFW_KEY_HOME}}},
     "Go to the beginning of the timeline",
     [](ViewerState& state, double now) {
         if (state.session.has_timeline()) state.session.seek(state.session.family().timeline->begin(), now);
     }},
    {"Playback",
     "End",
     {{{GLFW_KEY_END}}},
     "Go to the end of the timeline",
     [](ViewerState& state, double now) {
         if (state.session.has_timeline()) state.session.seek(state.session.family().timeline->end(), now);
     }},
    {"Playback",
     "Step back",
     {{{GLFW_KEY_LEFT}}},
     "Go back by a hundredth of the timeline",
     [](ViewerState& state, double now) { step(state, -1, now); },
     nullptr,
     true},
    {"Playback",
     "Step forward",
     {{{GLFW_KEY_RIGHT}}},
     "Go on by a hundredth of the timeline",
     [](ViewerState& state, double now) { step(state, 1, now); },
     nullptr,
     true},
    {"Playback",
     "Key before",
     {{{GLFW_KEY_LEFT, GLFW_MOD_CONTROL}, {GLFW_KEY_PAGE_UP}}},
     "Go to the key before on the timeline",
     [](ViewerState& state, double now) { state.session.seek_key(-1, now); }},
    {"Playback",
     "Next key",
     {{{GLFW_KEY_RIGHT, GLFW_MOD_CONTROL}, {GLFW_KEY_PAGE_DOWN}}},
     "Go to the next key on the timeline",
     [](ViewerState& state, double now) { state.session.seek_key(1, now); }},

    {"View",
     "Frame model",
     {{{GLFW_KEY_F}}},
     "See the whole of what is shown (or double-click it)",
     [](ViewerState& state, double) { state.framing = Framing::surface; }},
    {"View",
     "Smooth shading",
     {{{GLFW_KEY_S}}},
     "Shade smoothly, or each triangle flat",
     toggle_shading,
     [](const ViewerState& state) { return state.session.display.shading == Shading::smooth; }},
    {"View",
     "Wireframe",
     {{{GLFW_KEY_W}, {GLFW_KEY_1}}},
     "Show the edges of the leaves",
     toggle<&Display::wireframe>,
     is_on<&Display::wireframe>},
    {"View",
     "Refinement edges",
     {{{GLFW_KEY_R}, {GLFW_KEY_2}}},
     "Show the edge that bisection would split next",
     toggle<&Display::refinement_edges>,
     is_on<&Display::refinement_edges>},
    {"View",
     "Root edges",
     {{{GLFW_KEY_E}, {GLFW_KEY_3}}},
     "Show the edges of the root complex",
     toggle<&Display::root_edges>,
     is_on<&Display::root_edges>},
    {"View",
     "Next colouring",
     {{{GLFW_KEY_C}}},
     "Colour plainly, by level, by origin, checker, by field",
     cycle_coloring},
    {"View",
     "Compare with mesh",
     {{{GLFW_KEY_M}}},
     "See fitted keys beside their meshes, with the distances",
     toggle_comparison,
     [](const ViewerState& state) { return state.is_comparing; },
     false,
     can_compare},
    {"View",
     "Reload shaders",
     {{{GLFW_KEY_F5}}},
     "Read the shader files again",
     [](ViewerState& state, double) { state.reload_wanted = true; }},

    {"Help",
     "Keys and mouse",
     {{{GLFW_KEY_F1}, {GLFW_KEY_H}}},
     "Show or hide this help",
     [](ViewerState& state, double) { state.help_shown = !state.help_shown; },
     [](const ViewerState& state) { return state.help_shown; }},
    {"Help",
     "Dismiss",
     {{{GLFW_KEY_ESCAPE}}},
     "Close the message, the help or the comparison",
     [](ViewerState& state, double) {
         if (!state.message.empty())
             state.message.clear();
         else if (state.help_shown)
             state.help_shown = false;
         else
             state.is_comparing = false;
     }},
};

}  // namespace

std::span<const Command> commands() {
    return table;
}

const Command* find_command(Shortcut shortcut) {
    const auto* const found = std::ranges::find_if(table, [shortcut](const Command& command) {
        return shortcut.key != 0 && std::ranges::find(command.shortcuts, shortcut) != command.shortcuts.end();
    });
    return found == std::end(table) ? nullptr : found;
}

bool is_enabled(const Command& command, const ViewerState& state) {
    if (state.is_comparing && is_about_document(command)) return false;
    return command.is_enabled == nullptr || command.is_enabled(state);
}

void run_command(const Command& command, ViewerState& state, double now) {
    if (is_enabled(command, state)) command.run(state, now);
}

const Command& command_named(std::string_view name) {
    const auto* const found = std::ranges::find(table, name, &Command::name);
    assert(found != std::end(table));
    return *found;
}

}  // namespace interleaf
