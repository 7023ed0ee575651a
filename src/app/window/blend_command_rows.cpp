// The commands of the menu Blend.
#include "app/window/command_rows.h"

// GLFW must not include OpenGL headers of its own.
#define GLFW_INCLUDE_NONE

#include <GLFW/glfw3.h>

#include "app/document/blend_commands.h"

namespace interleaf {

namespace {

template <Driver driver>
void drive(ViewerState& state, double now) {
    choose_driver(state, driver, now);
}

template <Driver driver>
bool drives(const ViewerState& state) {
    return state.session.driver() == driver;
}

template <Driver driver>
bool may_drive(const ViewerState& state) {
    return state.session.can_drive(driver);
}

constexpr Command blend_table[] = {
    {.id = CommandId::drive_by_timeline,
     .scope = CommandScope::document,
     .menu = "Blend",
     .name = "Follow timeline",
     .shortcuts = {{{GLFW_KEY_1, GLFW_MOD_ALT}}},
     .description = "Blend by the present time",
     .run = drive<Driver::timeline>,
     .is_on = drives<Driver::timeline>,
     .is_possible = may_drive<Driver::timeline>},
    {.id = CommandId::drive_by_domain,
     .scope = CommandScope::document,
     .menu = "Blend",
     .name = "Follow point in domain",
     .shortcuts = {{{GLFW_KEY_2, GLFW_MOD_ALT}}},
     .description = "Blend by the point of the parameter domain where it was last",
     .run = drive<Driver::point>,
     .is_on = drives<Driver::point>,
     .is_possible = may_drive<Driver::point>},
    {.id = CommandId::show_one_key,
     .scope = CommandScope::document,
     .menu = "Blend",
     .name = "Show one key",
     .shortcuts = {{{GLFW_KEY_3, GLFW_MOD_ALT}}},
     .description = "Show the selected key alone, or the key with the largest weight",
     .run = drive<Driver::key>,
     .is_on = drives<Driver::key>},
    {.id = CommandId::drive_by_weights,
     .scope = CommandScope::document,
     .menu = "Blend",
     .name = "Hold weights",
     .shortcuts = {{{GLFW_KEY_4, GLFW_MOD_ALT}}},
     .description = "Blend by the present weights, and by their sliders",
     .run = drive<Driver::weights>,
     .is_on = drives<Driver::weights>},
    {.id = CommandId::turn_parts,
     .scope = CommandScope::document,
     .menu = "Blend",
     .name = "Turn parts",
     .shortcuts = {{{GLFW_KEY_B, GLFW_MOD_ALT}}},
     .description = "Parts that turn from key to key turn on the way, instead of shrinking",
     .run = toggle_turning,
     .is_on = is_turning},
    {.id = CommandId::sum_to_one,
     .scope = CommandScope::document,
     .menu = "Blend",
     .name = "Make weights sum to 1",
     .shortcuts = {{{GLFW_KEY_N, GLFW_MOD_SHIFT}}},
     .description = "Divide all weights by their sum",
     .run = make_weights_sum_to_one,
     .is_possible = can_make_weights_sum_to_one},
    {.id = CommandId::reset_weights,
     .scope = CommandScope::document,
     .menu = "Blend",
     .name = "Reset weights",
     .shortcuts = {{{GLFW_KEY_BACKSPACE, GLFW_MOD_ALT}}},
     .description = "Return to the weights before the first slider moved",
     .run = reset_weights,
     .is_possible = can_reset_weights},
};

}  // namespace

std::span<const Command> blend_commands() {
    return blend_table;
}

}  // namespace interleaf
