// The commands of the menu View that change how the window looks.
#include "app/window/command_rows.h"

// GLFW must not include OpenGL headers of its own.
#define GLFW_INCLUDE_NONE

#include <algorithm>

#include <GLFW/glfw3.h>

namespace interleaf {

namespace {

void toggle_theme(ViewerState& state, double) {
    Theme& theme = state.appearance.theme;
    theme = theme == Theme::dark ? Theme::light : Theme::dark;
    state.has_theme_of_run = false;
}

void scale_text(ViewerState& state, float step) {
    float& scale = state.appearance.text_scale;
    scale = std::clamp(scale + step, min_text_scale, max_text_scale);
}

constexpr Command appearance_table[] = {
    {.id = CommandId::light_theme,
     .menu = "View",
     .name = "Light theme",
     .shortcuts = {{{GLFW_KEY_T, GLFW_MOD_CONTROL}}},
     .description = "Show the window and the surface's background light, or dark",
     .run = toggle_theme,
     .is_on = [](const ViewerState& state) { return state.appearance.theme == Theme::light; }},
    {.id = CommandId::larger_text,
     .menu = "View",
     .name = "Larger text",
     .shortcuts = {{{GLFW_KEY_EQUAL, GLFW_MOD_CONTROL}}},
     .description = "Make text and controls larger",
     .run = [](ViewerState& state, double) { scale_text(state, text_scale_step); },
     .is_possible = [](const ViewerState& state) { return state.appearance.text_scale < max_text_scale; }},
    {.id = CommandId::smaller_text,
     .menu = "View",
     .name = "Smaller text",
     .shortcuts = {{{GLFW_KEY_MINUS, GLFW_MOD_CONTROL}}},
     .description = "Make text and controls smaller",
     .run = [](ViewerState& state, double) { scale_text(state, -text_scale_step); },
     .is_possible = [](const ViewerState& state) { return state.appearance.text_scale > min_text_scale; }},
    {.id = CommandId::usual_look,
     .menu = "View",
     .name = "Usual sizes",
     .shortcuts = {{{GLFW_KEY_0, GLFW_MOD_CONTROL}}},
     .description = "Give text and panels their usual sizes again",
     .run =
         [](ViewerState& state, double) {
             state.appearance.text_scale = 1;
             state.appearance.panels = {};
         }},
};

}  // namespace

std::span<const Command> appearance_commands() {
    return appearance_table;
}

}  // namespace interleaf
