// The commands of the menu Playback.
#include "app/window/command_rows.h"

// GLFW must not include OpenGL headers of its own.
#define GLFW_INCLUDE_NONE

#include <string>

#include <GLFW/glfw3.h>
#include <fmt/core.h>

#include "app/document/path_commands.h"
#include "app/document/playback_commands.h"

namespace interleaf {

namespace {

bool has_time(const ViewerState& state) {
    return state.session.has_time();
}

bool keys_drive(const ViewerState& state) {
    return state.session.has_timeline() && !path_drives(state);
}

bool has_domain_of_points(const ViewerState& state) {
    return state.document.family().domain.has_value();
}

bool has_path(const ViewerState& state) {
    return state.document.family().path.has_value();
}

template <bool backward>
bool plays(const ViewerState& state) {
    return state.session.is_playing() && state.session.plays_back() == backward;
}

std::string interpolation_label(const ViewerState& state) {
    const auto& timeline = state.document.family().timeline;
    return timeline ? fmt::format("Interpolation: {}", name_of(timeline->interpolation().basis))
                    : "Interpolation";
}

constexpr Command playback_table[] = {
    {.id = CommandId::play,
     .scope = CommandScope::document,
     .menu = "Playback",
     .name = "Play",
     .shortcuts = {{{GLFW_KEY_SPACE}}},
     .description = "Play or pause; the surface follows the timeline again",
     .run = [](ViewerState& state, double now) { state.session.toggle_playing(now); },
     .is_on = plays<false>,
     .is_possible = has_time},
    {.id = CommandId::play_backward,
     .scope = CommandScope::document,
     .menu = "Playback",
     .name = "Play backward",
     .shortcuts = {{{GLFW_KEY_SPACE, GLFW_MOD_SHIFT}}},
     .description = "Play from later to earlier times, or pause",
     .run = [](ViewerState& state, double now) { state.session.toggle_playing(now, true); },
     .is_on = plays<true>,
     .is_possible = has_time},
    {.id = CommandId::next_repeat,
     .scope = CommandScope::document,
     .menu = "Playback",
     .name = "Repeat",
     .shortcuts = {{{GLFW_KEY_L}}},
     .description = "At the end stop, loop, or go back and forth",
     .run = cycle_repeat,
     .is_possible = has_time,
     .label =
         [](const ViewerState& state) {
             return fmt::format("Repeat: {}", name_of(state.session.playback().repeat()));
         }},
    {.id = CommandId::go_to_start,
     .scope = CommandScope::document,
     .menu = "Playback",
     .name = "Go to start",
     .shortcuts = {{{GLFW_KEY_HOME}}},
     .description = "Go to the first key of the timeline",
     .run = [](ViewerState& state, double now) { state.session.seek(state.session.playback().begin(), now); },
     .is_possible = has_time},
    {.id = CommandId::go_to_end,
     .scope = CommandScope::document,
     .menu = "Playback",
     .name = "Go to end",
     .shortcuts = {{{GLFW_KEY_END}}},
     .description = "Go to the last key of the timeline",
     .run = [](ViewerState& state, double now) { state.session.seek(state.session.playback().end(), now); },
     .is_possible = has_time},
    {.id = CommandId::step_back,
     .scope = CommandScope::document,
     .menu = "Playback",
     .name = "Step back",
     .shortcuts = {{{GLFW_KEY_LEFT}}},
     .description = "Go back by a frame",
     .run = [](ViewerState& state, double now) { state.session.step_frame(-1, now); },
     .repeats = true,
     .is_possible = has_time},
    {.id = CommandId::step_forward,
     .scope = CommandScope::document,
     .menu = "Playback",
     .name = "Step forward",
     .shortcuts = {{{GLFW_KEY_RIGHT}}},
     .description = "Go forward by a frame",
     .run = [](ViewerState& state, double now) { state.session.step_frame(1, now); },
     .repeats = true,
     .is_possible = has_time},
    {.id = CommandId::go_to_previous_key,
     .scope = CommandScope::document,
     .menu = "Playback",
     .name = "Go to previous key",
     .shortcuts = {{{GLFW_KEY_LEFT, GLFW_MOD_CONTROL}, {GLFW_KEY_PAGE_UP}}},
     .description = "Go to the previous key on the timeline",
     .run = [](ViewerState& state, double now) { state.session.seek_key(-1, now); },
     .repeats = true,
     .is_possible = has_time},
    {.id = CommandId::go_to_next_key,
     .scope = CommandScope::document,
     .menu = "Playback",
     .name = "Go to next key",
     .shortcuts = {{{GLFW_KEY_RIGHT, GLFW_MOD_CONTROL}, {GLFW_KEY_PAGE_DOWN}}},
     .description = "Go to the next key on the timeline",
     .run = [](ViewerState& state, double now) { state.session.seek_key(1, now); },
     .repeats = true,
     .is_possible = has_time},
    {.id = CommandId::go_to_time,
     .scope = CommandScope::document,
     .menu = "Playback",
     .name = "Go to time...",
     .shortcuts = {{{GLFW_KEY_G}}},
     .description = "Type the time to go to",
     .run = [](ViewerState& state, double) { ask_for_present_time(state); },
     .is_possible = has_time},
    {.id = CommandId::slower,
     .scope = CommandScope::document,
     .menu = "Playback",
     .name = "Slower",
     .shortcuts = {{{GLFW_KEY_LEFT_BRACKET}}},
     .description = "Play at half the speed",
     .run = [](ViewerState& state, double now) { change_speed(state, -1, now); },
     .repeats = true,
     .is_possible = has_time},
    {.id = CommandId::faster,
     .scope = CommandScope::document,
     .menu = "Playback",
     .name = "Faster",
     .shortcuts = {{{GLFW_KEY_RIGHT_BRACKET}}},
     .description = "Play at twice the speed",
     .run = [](ViewerState& state, double now) { change_speed(state, 1, now); },
     .repeats = true,
     .is_possible = has_time},
    {.id = CommandId::normal_speed,
     .scope = CommandScope::document,
     .menu = "Playback",
     .name = "Normal speed",
     .shortcuts = {{{GLFW_KEY_BACKSPACE}}},
     .description = "Play in real time",
     .run = [](ViewerState& state, double now) { state.session.set_speed(1, now); },
     .is_possible = has_time},
    {.id = CommandId::set_speed,
     .scope = CommandScope::document,
     .menu = "Playback",
     .name = "Set speed...",
     .shortcuts = {{{GLFW_KEY_BACKSPACE, GLFW_MOD_SHIFT}}},
     .description = "Type the speed of playback, from 1/64 to 8",
     .run = [](ViewerState& state, double) { ask_for_speed(state); },
     .is_possible = has_time},
    {.id = CommandId::set_frame_rate,
     .scope = CommandScope::document,
     .menu = "Playback",
     .name = "Set frame rate...",
     .shortcuts = {{{GLFW_KEY_R, GLFW_MOD_SHIFT}}},
     .description = "Type the frames per second that single steps have",
     .run = [](ViewerState& state, double) { ask_for_frame_rate(state); },
     .is_possible = has_time},
    {.id = CommandId::set_in,
     .scope = CommandScope::document,
     .menu = "Playback",
     .name = "Set in point",
     .shortcuts = {{{GLFW_KEY_I}}},
     .description = "Play from the present time on",
     .run = [](ViewerState& state, double now) { set_in_point(state, state.session.time(), now); },
     .is_possible = has_time},
    {.id = CommandId::set_out,
     .scope = CommandScope::document,
     .menu = "Playback",
     .name = "Set out point",
     .shortcuts = {{{GLFW_KEY_O}}},
     .description = "Play up to the present time",
     .run = [](ViewerState& state, double now) { set_out_point(state, state.session.time(), now); },
     .is_possible = has_time},
    {.id = CommandId::play_all,
     .scope = CommandScope::document,
     .menu = "Playback",
     .name = "Play whole timeline",
     .shortcuts = {{{GLFW_KEY_U}}},
     .description = "Remove the in and out points",
     .run = [](ViewerState& state, double now) { state.session.set_range({}, now); },
     .is_possible = [](const ViewerState& state) { return state.session.playback().has_range(); }},
    {.id = CommandId::next_interpolation,
     .scope = CommandScope::document,
     .menu = "Playback",
     .name = "Interpolation",
     .shortcuts = {{{GLFW_KEY_B}}},
     .description = "Blend keys by the next kind of interpolation",
     .run = cycle_interpolation,
     .is_possible = keys_drive,
     .label = interpolation_label},
    {.id = CommandId::bernstein_pieces,
     .scope = CommandScope::document,
     .menu = "Playback",
     .name = "Bernstein pieces...",
     .shortcuts = {{{GLFW_KEY_B, GLFW_MOD_SHIFT}}},
     .description = "Blend keys by Bernstein polynomials of a degree, joined at keys",
     .run = [](ViewerState& state, double) { ask_for_degree(state); },
     .is_possible = keys_drive},
    {.id = CommandId::remove_present_time,
     .scope = CommandScope::document,
     .menu = "Playback",
     .name = "Take key off here",
     .shortcuts = {{{GLFW_KEY_DELETE, GLFW_MOD_SHIFT}}},
     .description = "Take the key at the present time off the timeline",
     .run = remove_present_time,
     .is_possible = has_present_time},
    {.id = CommandId::record_path,
     .scope = CommandScope::document,
     .menu = "Playback",
     .name = "Record path",
     .shortcuts = {{{GLFW_KEY_P}}},
     .description = "Begin or end to record a path: drag the point through the domain",
     .run = toggle_recording,
     .is_on = [](const ViewerState& state) { return state.recording.has_value(); },
     .is_possible = has_domain_of_points},
    {.id = CommandId::follow_path,
     .scope = CommandScope::document,
     .menu = "Playback",
     .name = "Follow path",
     .shortcuts = {{{GLFW_KEY_P, GLFW_MOD_SHIFT}}},
     .description = "Let the path through the domain drive instead of the keys, or the keys again",
     .run = toggle_time_source,
     .is_on = path_drives,
     .is_possible = has_path},
    {.id = CommandId::smooth_path,
     .scope = CommandScope::document,
     .menu = "Playback",
     .name = "Smooth path",
     .shortcuts = {{{GLFW_KEY_P, GLFW_MOD_ALT}}},
     .description = "Smooth the path through the domain",
     .run = smooth_path,
     .is_possible = has_path},
    {.id = CommandId::remove_path,
     .scope = CommandScope::document,
     .menu = "Playback",
     .name = "Remove path",
     .shortcuts = {{{GLFW_KEY_P, GLFW_MOD_CONTROL | GLFW_MOD_SHIFT}}},
     .description = "Remove the path through the domain",
     .run = remove_path,
     .is_possible = has_path},
    {.id = CommandId::show_all_times,
     .scope = CommandScope::document,
     .menu = "Playback",
     .name = "Show all times",
     .shortcuts = {{{GLFW_KEY_HOME, GLFW_MOD_SHIFT}}},
     .description = "Show the whole timeline again (the wheel shows a part)",
     .run = [](ViewerState& state, double) { state.shown_times.reset(); },
     .is_possible = [](const ViewerState& state) { return state.shown_times.has_value(); }},
};

}  // namespace

std::span<const Command> playback_commands() {
    return playback_table;
}

}  // namespace interleaf
