// The commands of the menu Camera.
#include "app/window/command_rows.h"

// GLFW must not include OpenGL headers of its own.
#define GLFW_INCLUDE_NONE

#include <GLFW/glfw3.h>

namespace interleaf {

namespace {

constexpr float turn_step = 5;  // degrees
constexpr float zoom_step = 1.12F;

template <int azimuth, int elevation>
void look_along(ViewerState& state, double) {
    state.camera_wishes.moves.emplace_back([](Camera& camera) { camera.look_from(azimuth, elevation); });
}

/// Turns as a drag by so many steps would, x right, y down.
template <int x, int y>
void turn_by_key(ViewerState& state, double) {
    state.camera_wishes.moves.emplace_back([style = state.camera.orbit](Camera& camera) {
        camera.orbit(turn_step / 180 * glm::vec2(x, y), style);
    });
}

template <int steps>
void roll_by_key(ViewerState& state, double) {
    state.camera_wishes.moves.emplace_back([](Camera& camera) { camera.roll(steps * turn_step); });
}

template <ClipboardWish wish>
void wish_for_clipboard(ViewerState& state, double) {
    state.camera_wishes.clipboard = wish;
}

void toggle_projection(ViewerState& state, double) {
    Projection& projection = state.camera.projection;
    projection = projection == Projection::perspective ? Projection::orthographic : Projection::perspective;
}

template <UpAxis up>
void turn_up_axis(ViewerState& state, double) {
    state.camera.up = state.camera.chosen_up = up;
}

template <UpAxis up>
bool is_up_axis(const ViewerState& state) {
    return state.camera.up == up;
}

void toggle_orbit_style(ViewerState& state, double) {
    OrbitStyle& orbit = state.camera.orbit;
    orbit = orbit == OrbitStyle::turntable ? OrbitStyle::trackball : OrbitStyle::turntable;
}

constexpr Command camera_table[] = {
    {.id = CommandId::frame_model,
     .menu = "Camera",
     .name = "Frame model",
     .shortcuts = {{{GLFW_KEY_F}}},
     .description = "See the whole surface that is shown (or double-click it)",
     .run = [](ViewerState& state, double) { state.view_target = ViewTarget::surface; }},
    {.id = CommandId::view_front,
     .menu = "Camera",
     .name = "Front view",
     .shortcuts = {{{GLFW_KEY_1, GLFW_MOD_CONTROL}, {GLFW_KEY_KP_1}}},
     .description = "Look from the front, the positive end of Z while Y points up",
     .run = look_along<0, 0>},
    {.id = CommandId::view_back,
     .menu = "Camera",
     .name = "Back view",
     .shortcuts = {{{GLFW_KEY_2, GLFW_MOD_CONTROL}, {GLFW_KEY_KP_1, GLFW_MOD_CONTROL}}},
     .description = "Look from the back",
     .run = look_along<180, 0>},
    {.id = CommandId::view_left,
     .menu = "Camera",
     .name = "Left view",
     .shortcuts = {{{GLFW_KEY_3, GLFW_MOD_CONTROL}, {GLFW_KEY_KP_3, GLFW_MOD_CONTROL}}},
     .description = "Look from the left",
     .run = look_along<-90, 0>},
    {.id = CommandId::view_right,
     .menu = "Camera",
     .name = "Right view",
     .shortcuts = {{{GLFW_KEY_4, GLFW_MOD_CONTROL}, {GLFW_KEY_KP_3}}},
     .description = "Look from the right",
     .run = look_along<90, 0>},
    {.id = CommandId::view_top,
     .menu = "Camera",
     .name = "Top view",
     .shortcuts = {{{GLFW_KEY_5, GLFW_MOD_CONTROL}, {GLFW_KEY_KP_7}}},
     .description = "Look down from above",
     .run = look_along<0, 90>},
    {.id = CommandId::view_bottom,
     .menu = "Camera",
     .name = "Bottom view",
     .shortcuts = {{{GLFW_KEY_6, GLFW_MOD_CONTROL}, {GLFW_KEY_KP_7, GLFW_MOD_CONTROL}}},
     .description = "Look up from below",
     .run = look_along<0, -90>},
    {.id = CommandId::usual_view,
     .menu = "Camera",
     .name = "Usual view",
     .shortcuts = {{{GLFW_KEY_7, GLFW_MOD_CONTROL}, {GLFW_KEY_KP_0}}},
     .description = "Look from the front, a little from above and the right",
     .run = look_along<30, 20>},
    {.id = CommandId::orthographic,
     .menu = "Camera",
     .name = "Orthographic",
     .shortcuts = {{{GLFW_KEY_O, GLFW_MOD_SHIFT}, {GLFW_KEY_KP_5}}},
     .description = "Show parallel lines parallel, without perspective",
     .run = toggle_projection,
     .is_on = [](const ViewerState& state) { return state.camera.projection == Projection::orthographic; }},
    {.id = CommandId::x_up,
     .menu = "Camera",
     .name = "X up",
     .shortcuts = {{{GLFW_KEY_X, GLFW_MOD_ALT}}},
     .description = "Let the X axis point up in the view",
     .run = turn_up_axis<UpAxis::x>,
     .is_on = is_up_axis<UpAxis::x>},
    {.id = CommandId::y_up,
     .menu = "Camera",
     .name = "Y up",
     .shortcuts = {{{GLFW_KEY_Y, GLFW_MOD_ALT}}},
     .description = "Let the Y axis point up in the view",
     .run = turn_up_axis<UpAxis::y>,
     .is_on = is_up_axis<UpAxis::y>},
    {.id = CommandId::z_up,
     .menu = "Camera",
     .name = "Z up",
     .shortcuts = {{{GLFW_KEY_Z, GLFW_MOD_ALT}}},
     .description = "Let the Z axis point up in the view, as many programs for numerics do",
     .run = turn_up_axis<UpAxis::z>,
     .is_on = is_up_axis<UpAxis::z>},
    {.id = CommandId::trackball,
     .menu = "Camera",
     .name = "Trackball",
     .shortcuts = {{{GLFW_KEY_O, GLFW_MOD_ALT}}},
     .description = "Let drags turn the surface freely, not about the vertical axis and up to the poles",
     .run = toggle_orbit_style,
     .is_on = [](const ViewerState& state) { return state.camera.orbit == OrbitStyle::trackball; }},
    {.id = CommandId::spin,
     .menu = "Camera",
     .name = "Spin",
     .shortcuts = {{{GLFW_KEY_S, GLFW_MOD_SHIFT}}},
     .description = "Turn slowly about the vertical axis",
     .run = [](ViewerState& state, double) { state.camera.spins = !state.camera.spins; },
     .is_on = [](const ViewerState& state) { return state.camera.spins; }},
    {.id = CommandId::turn_left,
     .menu = "Camera",
     .name = "Turn left",
     .shortcuts = {{{GLFW_KEY_LEFT, GLFW_MOD_SHIFT}, {GLFW_KEY_KP_4}}},
     .description = "Turn the surface as a drag to the left does",
     .run = turn_by_key<-1, 0>,
     .repeats = true},
    {.id = CommandId::turn_right,
     .menu = "Camera",
     .name = "Turn right",
     .shortcuts = {{{GLFW_KEY_RIGHT, GLFW_MOD_SHIFT}, {GLFW_KEY_KP_6}}},
     .description = "Turn the surface as a drag to the right does",
     .run = turn_by_key<1, 0>,
     .repeats = true},
    {.id = CommandId::turn_up,
     .menu = "Camera",
     .name = "Turn up",
     .shortcuts = {{{GLFW_KEY_UP, GLFW_MOD_SHIFT}, {GLFW_KEY_KP_8}}},
     .description = "Turn the surface as a drag upward does",
     .run = turn_by_key<0, -1>,
     .repeats = true},
    {.id = CommandId::turn_down,
     .menu = "Camera",
     .name = "Turn down",
     .shortcuts = {{{GLFW_KEY_DOWN, GLFW_MOD_SHIFT}, {GLFW_KEY_KP_2}}},
     .description = "Turn the surface as a drag downward does",
     .run = turn_by_key<0, 1>,
     .repeats = true},
    {.id = CommandId::roll_left,
     .menu = "Camera",
     .name = "Roll left",
     .shortcuts = {{{GLFW_KEY_LEFT, GLFW_MOD_ALT}}},
     .description = "Turn the picture counterclockwise (or Ctrl + right drag about its center)",
     .run = roll_by_key<1>,
     .repeats = true},
    {.id = CommandId::roll_right,
     .menu = "Camera",
     .name = "Roll right",
     .shortcuts = {{{GLFW_KEY_RIGHT, GLFW_MOD_ALT}}},
     .description = "Turn the picture clockwise",
     .run = roll_by_key<-1>,
     .repeats = true},
    {.id = CommandId::zoom_in,
     .menu = "Camera",
     .name = "Zoom in",
     .shortcuts = {{{GLFW_KEY_EQUAL, GLFW_MOD_SHIFT}, {GLFW_KEY_KP_ADD}}},
     .description = "Come nearer to the middle of the picture (the wheel: to the pointer)",
     .run = [](ViewerState& state, double) { state.camera_wishes.zoom *= zoom_step; },
     .repeats = true},
    {.id = CommandId::zoom_out,
     .menu = "Camera",
     .name = "Zoom out",
     .shortcuts = {{{GLFW_KEY_MINUS, GLFW_MOD_SHIFT}, {GLFW_KEY_KP_SUBTRACT}}},
     .description = "Go away from the surface",
     .run = [](ViewerState& state, double) { state.camera_wishes.zoom /= zoom_step; },
     .repeats = true},
    {.id = CommandId::show_axes,
     .menu = "Camera",
     .name = "Axes",
     .shortcuts = {{{GLFW_KEY_A, GLFW_MOD_ALT}}},
     .description = "Show the axes in a corner of the view; click one to look along it",
     .run = [](ViewerState& state, double) { state.camera.shows_axes = !state.camera.shows_axes; },
     .is_on = [](const ViewerState& state) { return state.camera.shows_axes; }},
    {.id = CommandId::copy_view,
     .scope = CommandScope::document,
     .menu = "Camera",
     .name = "Copy view",
     .shortcuts = {{{GLFW_KEY_C, GLFW_MOD_CONTROL | GLFW_MOD_SHIFT}}},
     .description = "Copy the view as text, the value of --camera",
     .run = wish_for_clipboard<ClipboardWish::copy_view>},
    {.id = CommandId::paste_view,
     .scope = CommandScope::document,
     .menu = "Camera",
     .name = "Paste view",
     .shortcuts = {{{GLFW_KEY_V, GLFW_MOD_CONTROL | GLFW_MOD_SHIFT}}},
     .description = "Take the view that was copied, also from another window",
     .run = wish_for_clipboard<ClipboardWish::paste_view>},
    {.id = CommandId::copy_command,
     .scope = CommandScope::document,
     .menu = "Camera",
     .name = "Copy as command",
     .shortcuts = {{{GLFW_KEY_C, GLFW_MOD_CONTROL | GLFW_MOD_ALT}}},
     .description = "Copy the command line that draws the present picture",
     .run = wish_for_clipboard<ClipboardWish::copy_command>},
};

}  // namespace

std::span<const Command> camera_commands() {
    return camera_table;
}

}  // namespace interleaf
