// The commands of the menu Help.
#include "app/window/command_rows.h"

// GLFW must not include OpenGL headers of its own.
#define GLFW_INCLUDE_NONE

#include <GLFW/glfw3.h>

namespace interleaf {

namespace {

constexpr Command help_table[] = {
    {.id = CommandId::open_menu,
     .menu = "Help",
     .name = "Open menu",
     .shortcuts = {{{GLFW_KEY_F10}}},
     .description = "Open the first menu, as pressing and releasing Alt does",
     .run = [](ViewerState& state, double) { state.menu_wanted = true; }},
    {.id = CommandId::next_panel,
     .scope = CommandScope::document,
     .menu = "Help",
     .name = "Go to next panel",
     .shortcuts = {{{GLFW_KEY_F6}, {GLFW_KEY_TAB}}},
     .description = "Give the keyboard to the next panel; Esc takes it back",
     .run = [](ViewerState& state, double) { state.panel_step = 1; }},
    {.id = CommandId::previous_panel,
     .scope = CommandScope::document,
     .menu = "Help",
     .name = "Go to previous panel",
     .shortcuts = {{{GLFW_KEY_F6, GLFW_MOD_SHIFT}}},
     .description = "Give the keyboard to the previous panel",
     .run = [](ViewerState& state, double) { state.panel_step = -1; }},
    {.id = CommandId::search_commands,
     .menu = "Help",
     .name = "Find command...",
     .shortcuts = {{{GLFW_KEY_P, GLFW_MOD_CONTROL}}},
     .description = "Search commands, keys and recent files by name, and run what is found",
     .run = [](ViewerState& state, double) { state.search_wanted = true; }},
    {.id = CommandId::find,
     .menu = "Help",
     .name = "Find",
     .shortcuts = {{{GLFW_KEY_F, GLFW_MOD_CONTROL}}},
     .description = "Search the list of keys, or the help while it is shown",
     .run =
         [](ViewerState& state, double) {
             state.find_wanted = true;
             if (!state.help_shown) state.key_search.is_shown = true;
         }},
    {.id = CommandId::help,
     .menu = "Help",
     .name = "Keys and mouse",
     .shortcuts = {{{GLFW_KEY_F1}, {GLFW_KEY_H}}},
     .description = "Show or hide this help",
     .run =
         [](ViewerState& state, double) {
             state.help_shown = !state.help_shown;
             state.help_search.clear();
         },
     .is_on = [](const ViewerState& state) { return state.help_shown; }},
    {.id = CommandId::dismiss,
     .menu = "Help",
     .name = "Dismiss",
     .shortcuts = {{{GLFW_KEY_ESCAPE}}},
     .description =
         "Take back the brush stroke; close the message, the help, the comparison or the inspector",
     .run =
         [](ViewerState& state, double) {
             if (state.brush.is_stroking)
                 state.brush.wants_to_cancel = true;
             else if (!state.message.empty())
                 state.message.clear();
             else if (state.help_shown)
                 state.help_shown = false;
             else if (state.domain_has_focus)
                 state.domain_has_focus = false;
             else if (state.is_comparing)
                 state.is_comparing = false;
             else if (state.brush.is_on)
                 state.brush.is_on = false;
             else
                 state.inspected.reset();
         }},
};

}  // namespace

std::span<const Command> help_commands() {
    return help_table;
}

}  // namespace interleaf
