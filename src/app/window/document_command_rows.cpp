// The commands of the menus File, Edit and Key.
#include "app/window/command_rows.h"

// GLFW must not include OpenGL headers of its own.
#define GLFW_INCLUDE_NONE

#include <GLFW/glfw3.h>
#include <fmt/core.h>

#include "app/brushing/brush_stroke.h"
#include "app/document/edit_commands.h"
#include "app/document/path_commands.h"
#include "app/document/playback_commands.h"
#include "app/document/unit_commands.h"

namespace interleaf {

namespace {

template <FileWish wish>
void wish_for(ViewerState& state, double) {
    state.file_wish = wish;
}

bool has_domain(const ViewerState& state) {
    return state.document.family().domain.has_value();
}

std::string step_label(const char* command, const std::string* step) {
    return step != nullptr ? fmt::format("{} {}", command, *step) : command;
}

constexpr Command document_table[] = {
    {.id = CommandId::open,
     .menu = "File",
     .name = "Open...",
     .shortcuts = {{{GLFW_KEY_O, GLFW_MOD_CONTROL}}},
     .description = "Open a family, keys or meshes (or drop files on the picture)",
     .run = wish_for<FileWish::open>},
    {.id = CommandId::import_series,
     .menu = "File",
     .name = "Import series...",
     .shortcuts = {{{GLFW_KEY_I, GLFW_MOD_CONTROL | GLFW_MOD_SHIFT}}},
     .description = "Open a series from numerics with other options than Open takes",
     .run = wish_for<FileWish::import_series>},
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
     .name = "Save as...",
     .shortcuts = {{{GLFW_KEY_S, GLFW_MOD_CONTROL | GLFW_MOD_SHIFT}}},
     .description = "Save the family in another folder",
     .run = wish_for<FileWish::save_as>},
    {.id = CommandId::export_as,
     .menu = "File",
     .name = "Export...",
     .shortcuts = {{{GLFW_KEY_E, GLFW_MOD_CONTROL}}},
     .description = "Write the family or the blend for other programs, a picture or a film",
     .run = wish_for<FileWish::export_as>},
    {.id = CommandId::save_picture,
     .menu = "File",
     .name = "Save picture...",
     .shortcuts = {{{GLFW_KEY_F12}}},
     .description = "Draw what is seen into a PNG file, in any size, also on a transparent background",
     .run = wish_for<FileWish::save_picture>},
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
     .name = "Rename family...",
     .shortcuts = {{{GLFW_KEY_F2, GLFW_MOD_SHIFT}}},
     .description = "Give the family another name",
     .run = [](ViewerState& state, double) { ask_for_family_name(state); }},
    {.id = CommandId::set_field_unit,
     .scope = CommandScope::document,
     .menu = "Edit",
     .name = "Unit of field...",
     .shortcuts = {{{GLFW_KEY_U, GLFW_MOD_SHIFT}}},
     .description = "Type the unit of the shown field, for its legend and values",
     .run = [](ViewerState& state, double) { ask_for_field_unit(state); },
     .is_possible = [](const ViewerState& state) { return shown_scalar(state) != nullptr; }},
    {.id = CommandId::set_time_unit,
     .scope = CommandScope::document,
     .menu = "Edit",
     .name = "Unit of time...",
     .shortcuts = {{{GLFW_KEY_U, GLFW_MOD_ALT}}},
     .description = "Type the unit of the timeline's times",
     .run = [](ViewerState& state, double) { ask_for_time_unit(state); },
     .is_possible = [](const ViewerState& state) { return state.document.family().timeline.has_value(); }},
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
     .description = "Drag vertices of the parameter domain and points of its path, instead of the point",
     .run = [](ViewerState& state, double) { state.edits_domain = !state.edits_domain; },
     .is_on = [](const ViewerState& state) { return state.edits_domain; },
     .is_possible = has_domain},

    {.id = CommandId::add_keys,
     .scope = CommandScope::document,
     .menu = "Key",
     .name = "Add keys...",
     .shortcuts = {{{GLFW_KEY_I, GLFW_MOD_CONTROL}}},
     .description = "Add keys or meshes from files (or drop files on the list of keys)",
     .run = wish_for<FileWish::add_keys>},
    {.id = CommandId::set_landmarks,
     .scope = CommandScope::document,
     .menu = "Key",
     .name = "Set landmarks...",
     .shortcuts = {{{GLFW_KEY_L, GLFW_MOD_CONTROL}}},
     .description = "Fit the last meshes again, with points that correspond",
     .run = wish_for<FileWish::set_landmarks>,
     .is_possible = [](const ViewerState& state) { return state.can_set_landmarks; }},
    {.id = CommandId::keep_blend,
     .scope = CommandScope::document,
     .menu = "Key",
     .name = "Keep blend",
     .shortcuts = {{{GLFW_KEY_K, GLFW_MOD_CONTROL}}},
     .description = "Add the surface that is shown as a key",
     .run = keep_blend},
    {.id = CommandId::refine_brush,
     .scope = CommandScope::document,
     .menu = "Key",
     .name = "Refine brush",
     .shortcuts = {{{GLFW_KEY_X}}},
     .description = "Brush over the selected key to bisect its leaves, with Shift to coarsen them",
     .run = toggle_brush,
     .is_on = [](const ViewerState& state) { return state.brush.is_on; }},
    {.id = CommandId::rename_key,
     .scope = CommandScope::selected_key,
     .menu = "Key",
     .name = "Rename key...",
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
     .name = "Put on timeline...",
     .shortcuts = {{{GLFW_KEY_T}}},
     .description = "Put the selected key on the timeline (or drag it there)",
     .run = [](ViewerState& state, double) { ask_for_new_time(state); }},
    {.id = CommandId::add_present_time,
     .scope = CommandScope::selected_key,
     .menu = "Key",
     .name = "Put key here",
     .shortcuts = {{{GLFW_KEY_T, GLFW_MOD_SHIFT}}},
     .description = "Put the selected key on the timeline at the present time",
     .run = add_present_time},
    {.id = CommandId::put_in_domain,
     .scope = CommandScope::selected_key,
     .menu = "Key",
     .name = "Put in domain...",
     .shortcuts = {{{GLFW_KEY_D, GLFW_MOD_ALT}}},
     .description = "Type the place of the selected key in the domain (or drag it there)",
     .run = [](ViewerState& state, double) { ask_for_key_place(state); },
     .is_possible = has_domain},
    {.id = CommandId::take_out_of_domain,
     .scope = CommandScope::selected_key,
     .menu = "Key",
     .name = "Take out of domain",
     .shortcuts = {{{GLFW_KEY_D, GLFW_MOD_ALT | GLFW_MOD_SHIFT}}},
     .description = "Remove the vertex of the selected key from the domain",
     .run =
         [](ViewerState& state, double now) {
             if (const auto vertex = vertex_of_selected_key(state)) remove_domain_vertex(state, *vertex, now);
         },
     .is_possible = [](const ViewerState& state) { return vertex_of_selected_key(state).has_value(); }},
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
};

}  // namespace

std::span<const Command> document_commands() {
    return document_table;
}

}  // namespace interleaf
