// The commands of the menu View.
#include "app/window/command_rows.h"

// GLFW must not include OpenGL headers of its own.
#define GLFW_INCLUDE_NONE

#include <algorithm>

#include <GLFW/glfw3.h>

#include "app/document/fit_comparison.h"
#include "app/document/shown_shading.h"

namespace interleaf {

namespace {

void cycle_coloring(ViewerState& state, double) {
    if (state.is_comparing) {
        state.compares_colors = !state.compares_colors;
        return;
    }
    Display& display = state.session.display;
    display.coloring = next_coloring(display.coloring, !display.field.empty());
}

/// A material is seen only on a plain surface, so the first step shows it plainly.
void cycle_material(ViewerState& state, double) {
    Display& display = state.session.display;
    if (display.coloring == Coloring::plain) display.material = next_material(display.material);
    display.coloring = Coloring::plain;
}

/// Step of the commands that change the detail.
constexpr float detail_step = 0.02F;

void change_detail(ViewerState& state, float step) {
    Display& display = state.session.display;
    display.detail = std::clamp(display.detail + step, 0.0F, 1.0F);
    display.follows_camera = false;
}

void toggle_shading(ViewerState& state, double) {
    const bool is_smooth = shown_shading(state.session) == Shading::smooth;
    state.session.display.shading = is_smooth ? Shading::flat : Shading::smooth;
}

template <bool Display::*line>
void toggle(ViewerState& state, double) {
    state.session.display.*line = !(state.session.display.*line);
}

template <bool Display::*line>
bool is_on(const ViewerState& state) {
    return state.session.display.*line;
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

constexpr Command view_table[] = {
    {.id = CommandId::show_whole_domain,
     .scope = CommandScope::document,
     .menu = "View",
     .name = "Show whole domain",
     .shortcuts = {{{GLFW_KEY_F, GLFW_MOD_SHIFT}}},
     .description = "Show the whole parameter domain again (the wheel shows a part)",
     .run = [](ViewerState& state, double) { state.shown_domain.reset(); },
     .is_possible = [](const ViewerState& state) { return state.shown_domain.has_value(); }},
    {.id = CommandId::smooth_shading,
     .menu = "View",
     .name = "Smooth shading",
     .shortcuts = {{{GLFW_KEY_S}}},
     .description = "Shade smoothly, or each triangle flat, as keys of few leaves are at first",
     .run = toggle_shading,
     .is_on = [](const ViewerState& state) { return shown_shading(state.session) == Shading::smooth; }},
    {.id = CommandId::ambient_occlusion,
     .menu = "View",
     .name = "Ambient occlusion",
     .shortcuts = {{{GLFW_KEY_A}}},
     .description = "Darken hollows, where less light arrives",
     .run = toggle<&Display::occlusion>,
     .is_on = is_on<&Display::occlusion>},
    {.id = CommandId::ground,
     .menu = "View",
     .name = "Ground",
     .shortcuts = {{{GLFW_KEY_G, GLFW_MOD_CONTROL}}},
     .description = "Show a ground below the surface, with its soft shadow",
     .run = toggle<&Display::ground>,
     .is_on = is_on<&Display::ground>},
    {.id = CommandId::next_material,
     .menu = "View",
     .name = "Next material",
     .shortcuts = {{{GLFW_KEY_M, GLFW_MOD_CONTROL}}},
     .description = "Show a plain surface as clay, porcelain, steel, jade, or by its normals",
     .run = cycle_material},
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
    {.id = CommandId::vertices,
     .menu = "View",
     .name = "Vertices",
     .shortcuts = {{{GLFW_KEY_V}}},
     .description = "Show a dot at each vertex",
     .run = toggle<&Display::vertices>,
     .is_on = is_on<&Display::vertices>},
    {.id = CommandId::normals,
     .menu = "View",
     .name = "Normals",
     .shortcuts = {{{GLFW_KEY_N}}},
     .description = "Show a line along the normal at each vertex",
     .run = toggle<&Display::normals>,
     .is_on = is_on<&Display::normals>},
    {.id = CommandId::next_coloring,
     .menu = "View",
     .name = "Next coloring",
     .shortcuts = {{{GLFW_KEY_C}}},
     .description = "Color plainly, by level, by origin, and so on, as the buttons below Color do",
     .run = cycle_coloring},
    {.id = CommandId::less_detail,
     .menu = "View",
     .name = "Less detail",
     .shortcuts = {{{GLFW_KEY_MINUS}}},
     .description = "Show coarser levels of the keys",
     .run = [](ViewerState& state, double) { change_detail(state, -detail_step); },
     .repeats = true},
    {.id = CommandId::more_detail,
     .menu = "View",
     .name = "More detail",
     .shortcuts = {{{GLFW_KEY_EQUAL}}},
     .description = "Show finer levels of the keys",
     .run = [](ViewerState& state, double) { change_detail(state, detail_step); },
     .repeats = true},
    {.id = CommandId::follow_camera,
     .menu = "View",
     .name = "Detail follows camera",
     .shortcuts = {{{GLFW_KEY_C, GLFW_MOD_SHIFT}}},
     .description = "Show finer levels where the surface is seen large and at its silhouette",
     .run = toggle<&Display::follows_camera>,
     .is_on = is_on<&Display::follows_camera>},
    {.id = CommandId::keys_beside,
     .scope = CommandScope::document,
     .menu = "View",
     .name = "Keys beside blend",
     .shortcuts = {{{GLFW_KEY_K}}},
     .description = "Show the active keys beside their blend, with the node under the pointer in each",
     .run = [](ViewerState& state, double) { state.shows_keys_beside = !state.shows_keys_beside; },
     .is_on = [](const ViewerState& state) { return state.shows_keys_beside; }},
    {.id = CommandId::plot_blend,
     .scope = CommandScope::document,
     .menu = "View",
     .name = "Plots over time",
     .shortcuts = {{{GLFW_KEY_A, GLFW_MOD_SHIFT}}},
     .description = "Plot area, volume and leaves of the blend below the timeline",
     .run = [](ViewerState& state, double) { state.plots_blend = !state.plots_blend; },
     .is_on = [](const ViewerState& state) { return state.plots_blend; },
     .is_possible = [](const ViewerState& state) { return state.session.has_time(); }},
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
};

}  // namespace

std::span<const Command> view_commands() {
    return view_table;
}

}  // namespace interleaf
