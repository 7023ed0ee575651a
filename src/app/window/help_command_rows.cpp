// The commands of the menu Help.
#include "app/window/command_rows.h"

// GLFW must not include OpenGL headers of its own.
#define GLFW_INCLUDE_NONE

#include <GLFW/glfw3.h>

namespace interleaf {

namespace {

constexpr Command help_table[] = {
    {.id = CommandId::search_commands,
     .menu = "Help",
     .name = "Find command...",
     .shortcuts = {{{GLFW_KEY_P, GLFW_MOD_CONTROL}}},
     .description = "Search commands, keys and recent files by name, and run what is found",
     .run = [](ViewerState& state, double) { state.search_wanted = true; }},
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
     .description = "Take back the brush stroke; close the message, the help or the comparison",
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
             else
                 state.brush.is_on = false;
         }},
};

}  // namespace

std::span<const Command> help_commands() {
    return help_table;
}

}  // namespace interleaf
