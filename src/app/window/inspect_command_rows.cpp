// The commands of the menu Inspect.
#include "app/window/command_rows.h"

// GLFW must not include OpenGL headers of its own.
#define GLFW_INCLUDE_NONE

#include <GLFW/glfw3.h>

#include "hierarchy/nodes/node_steps.h"

namespace interleaf {

namespace {

template <NodeStep step>
void take_node_step(ViewerState& state, double) {
    state.node_step = step;
}

bool inspects(const ViewerState& state) {
    return state.inspected.has_value();
}

/// Also where the inspection begins with this frame.
bool is_inspecting(const ViewerState& state) {
    return state.inspected || state.inspects_middle;
}

constexpr Command inspect_table[] = {
    {.id = CommandId::inspect_leaf,
     .scope = CommandScope::document,
     .menu = "Inspect",
     .name = "Inspect leaf",
     .shortcuts = {{{GLFW_KEY_I, GLFW_MOD_SHIFT}}},
     .description = "Show what each active key has at the leaf in the middle of the picture, or end it (or "
                    "click a leaf)",
     .run =
         [](ViewerState& state, double) {
             state.inspects_middle = !is_inspecting(state);
             state.inspected.reset();
         },
     .is_on = is_inspecting},
    {.id = CommandId::go_to_parent,
     .scope = CommandScope::document,
     .menu = "Inspect",
     .name = "Go to parent",
     .shortcuts = {{{GLFW_KEY_UP, GLFW_MOD_CONTROL | GLFW_MOD_SHIFT}}},
     .description = "Inspect the triangle that was bisected into this one and its sibling",
     .run = take_node_step<NodeStep::parent>,
     .repeats = true,
     .is_possible = inspects},
    {.id = CommandId::go_to_sibling,
     .scope = CommandScope::document,
     .menu = "Inspect",
     .name = "Go to sibling",
     .shortcuts = {{{GLFW_KEY_RIGHT, GLFW_MOD_CONTROL | GLFW_MOD_SHIFT},
                    {GLFW_KEY_LEFT, GLFW_MOD_CONTROL | GLFW_MOD_SHIFT}}},
     .description = "Inspect the other child of the parent",
     .run = take_node_step<NodeStep::sibling>,
     .is_possible = inspects},
    {.id = CommandId::go_to_first_child,
     .scope = CommandScope::document,
     .menu = "Inspect",
     .name = "Go to first child",
     .shortcuts = {{{GLFW_KEY_DOWN, GLFW_MOD_CONTROL | GLFW_MOD_SHIFT}}},
     .description = "Inspect the first child (l, k, i)",
     .run = take_node_step<NodeStep::first_child>,
     .repeats = true,
     .is_possible = inspects},
    {.id = CommandId::go_to_second_child,
     .scope = CommandScope::document,
     .menu = "Inspect",
     .name = "Go to second child",
     .shortcuts = {{{GLFW_KEY_DOWN, GLFW_MOD_CONTROL | GLFW_MOD_ALT}}},
     .description = "Inspect the second child (l, i, j)",
     .run = take_node_step<NodeStep::second_child>,
     .repeats = true,
     .is_possible = inspects},
    {.id = CommandId::cross_refinement_edge,
     .scope = CommandScope::document,
     .menu = "Inspect",
     .name = "Cross refinement edge",
     .shortcuts = {{{GLFW_KEY_1, GLFW_MOD_CONTROL | GLFW_MOD_SHIFT}}},
     .description = "Inspect the neighbor across the edge from corner 2 to 3",
     .run = take_node_step<NodeStep::across_first>,
     .repeats = true,
     .is_possible = inspects},
    {.id = CommandId::cross_second_edge,
     .scope = CommandScope::document,
     .menu = "Inspect",
     .name = "Cross second edge",
     .shortcuts = {{{GLFW_KEY_2, GLFW_MOD_CONTROL | GLFW_MOD_SHIFT}}},
     .description = "Inspect the neighbor across the edge from corner 3 to 1",
     .run = take_node_step<NodeStep::across_second>,
     .repeats = true,
     .is_possible = inspects},
    {.id = CommandId::cross_third_edge,
     .scope = CommandScope::document,
     .menu = "Inspect",
     .name = "Cross third edge",
     .shortcuts = {{{GLFW_KEY_3, GLFW_MOD_CONTROL | GLFW_MOD_SHIFT}}},
     .description = "Inspect the neighbor across the edge from corner 1 to 2",
     .run = take_node_step<NodeStep::across_third>,
     .repeats = true,
     .is_possible = inspects},
};

}  // namespace

std::span<const Command> inspect_commands() {
    return inspect_table;
}

}  // namespace interleaf
