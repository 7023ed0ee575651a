#include "app/window/window_actions.h"

#include "app/document/blend_commands.h"
#include "app/document/brush.h"
#include "app/document/edit_commands.h"
#include "app/document/path_commands.h"
#include "app/document/playback_commands.h"
#include "app/window/commands.h"
#include "family/domain_edits.h"
#include "family/key_edits.h"

namespace interleaf {

namespace {

CommandId command_of_button(TransportButton button) {
    switch (button) {
        case TransportButton::first_key:
            return CommandId::go_to_start;
        case TransportButton::previous_key:
            return CommandId::go_to_previous_key;
        case TransportButton::step_back:
            return CommandId::step_back;
        case TransportButton::play_backward:
            return CommandId::play_backward;
        case TransportButton::play:
            return CommandId::play;
        case TransportButton::step_forward:
            return CommandId::step_forward;
        case TransportButton::next_key:
            return CommandId::go_to_next_key;
        case TransportButton::last_key:
            return CommandId::go_to_end;
        case TransportButton::ask_for_time:
            return CommandId::go_to_time;
        case TransportButton::ask_for_speed:
            return CommandId::set_speed;
        case TransportButton::ask_for_rate:
            return CommandId::set_frame_rate;
        case TransportButton::ask_for_degree:
            return CommandId::bernstein_pieces;
    }
    return CommandId::play;
}

void apply_to_vertices(const ParameterDomainResult& done, ViewerState& state, double now) {
    if (const auto& moved = done.moved_vertex) {
        drag_edit(
            state, "Move a domain vertex",
            [&](const Family& before) {
                Family after = before;
                after.domain = with_vertex_moved(*before.domain, moved->vertex, moved->to);
                return after;
            },
            now);
    }
    if (done.added) add_domain_vertex(state, done.added->at, done.added->key, done.snap, now);
    if (done.assigned) set_domain_vertex_key(state, done.assigned->vertex, done.assigned->key, now);
    if (done.asked_place) ask_for_vertex_place(state, *done.asked_place);
    if (done.removed) remove_domain_vertex(state, *done.removed, now);
}

/// \param held  what the mouse holds in the domain
void apply_to_path(const PathEdit& done, ViewerState& state, std::optional<DomainDrag>& held, double now) {
    const auto& path = state.document.family().path;
    if (!path) return;
    if (done.selected) select_path_point(state, *done.selected, now);
    if (done.inserted && !insert_path_point(state, *done.inserted, now) && held) held->path.reset();
    if (done.moved && done.moved->place < path->points().size())
        move_path_point(state, done.moved->place, {path->points()[done.moved->place].time, done.moved->to},
                        now);
    if (done.asked_time) ask_for_path_point_time(state, *done.asked_time);
    if (done.asked_place) ask_for_path_point_place(state, *done.asked_place);
    if (done.removed) remove_path_point(state, *done.removed, now);
}

/// Zooms and pans the domain, and gives the arrow keys to it.
void apply_to_domain_view(const ParameterDomainResult& done, ViewerState& state) {
    if (done.focus) state.domain_has_focus = *done.focus;
    if (!done.view) return;
    const DomainBox whole = box_of(state.document.family().domain->vertices());
    const bool is_whole = done.view->low == whole.low && done.view->high == whole.high;
    state.shown_domain = is_whole ? std::nullopt : done.view;
}

/// \param held  what the mouse holds in the domain
void apply_to_domain(const ParameterDomainResult& done, ViewerState& state, std::optional<DomainDrag>& held,
                     double now) {
    apply_to_domain_view(done, state);
    if (done.moved_to) state.session.move_point(*done.moved_to, now);
    if (done.moved_to) record_point(state, now);
    if (done.toggles_recording) toggle_recording(state, now);
    if (done.asks_for_place) ask_for_place(state);
    apply_to_path(done.path, state, held, now);
    apply_to_vertices(done, state, now);
}

void apply_to_transport(const TransportResult& done, ViewerState& state, double now) {
    if (done.pressed) run_command(command_of_button(*done.pressed), state, now);
    if (done.repeat) state.session.set_repeat(*done.repeat, now);
    if (done.speed) state.session.set_speed(*done.speed, now);
    if (done.frame_rate) state.session.frame_rate = *done.frame_rate;
    if (done.interpolation) choose_interpolation(state, *done.interpolation, now);
    if (done.blend) choose_blend(state, *done.blend, now);
    if (done.source) choose_time_source(state, *done.source, now);
}

/// \param range  a part of the timeline, or all of it
void show_times(ViewerState& state, TimeRange range) {
    const Playback& playback = state.session.playback();
    const bool is_whole = range.begin <= playback.begin() && range.end >= playback.end();
    state.shown_times = is_whole ? std::nullopt : std::optional(range);
}

void set_in_or_out(ViewerState& state, const RangeEdit& edit, double now) {
    if (edit.clears) state.session.set_range({}, now);
    if (edit.in) set_in_point(state, *edit.in, now);
    if (edit.out) set_out_point(state, *edit.out, now);
}

void apply_to_path_marks(const TrackResult& done, ViewerState& state, double now) {
    const auto points = state.document.family().path->points();
    if (const auto& moved = done.moved; moved && moved->place < points.size())
        move_path_point(state, moved->place, {moved->to, points[moved->place].at}, now);
    if (done.asked_time) ask_for_path_point_time(state, *done.asked_time);
    if (done.removed) remove_path_point(state, *done.removed, now);
}

void apply_to_key_marks(const TrackResult& done, ViewerState& state, double now) {
    if (const auto& moved = done.moved) {
        drag_edit(
            state, "Move a key in time",
            [&](const Family& before) { return with_time_moved(before, moved->place, moved->to); }, now);
    }
    if (done.added) add_time(state, done.added->key, done.added->time, now);
    if (done.asked_time) ask_for_time(state, *done.asked_time);
    if (done.removed) remove_time(state, *done.removed, now);
}

void apply_to_track(const TrackResult& done, ViewerState& state, double now) {
    Session& session = state.session;
    if (done.seek_to) session.seek(*done.seek_to, now);
    if (done.visible) show_times(state, *done.visible);
    if (done.range) set_in_or_out(state, *done.range, now);
    if (path_drives(state))
        apply_to_path_marks(done, state, now);
    else
        apply_to_key_marks(done, state, now);
}

void apply_to_help(const HelpResult& done, ViewerState& state) {
    if (done.search) state.help_search = *done.search;
    if (done.closed) state.help_shown = false;
}

/// Applies the settings of the brush; the strokes are applied to the surface (surface_brush.h).
void apply_to_brush(const BrushResult& done, ViewerState& state, double now) {
    if (done.toggled) run_command(CommandId::refine_brush, state, now);
    if (!done.settings) return;
    state.brush.radius = done.settings->radius;
    state.brush.refined_level = done.settings->refined_level;
    state.brush.coarsened_level = done.settings->coarsened_level;
}

void apply_to_keys(const KeysPanelResult& done, ViewerState& state, double now) {
    if (done.chosen) select_key(state, *done.chosen, now);
    if (done.renamed) ask_for_key_name(state);
    if (done.search) state.key_search = *done.search;
    if (done.toggled) toggle_key(state, *done.toggled, now);
    if (done.dragged) {
        state.selected_key = done.dragged;
        move_key(state, done.dropped_on, now);
    }
    if (done.menu_entry) run_command(*key_commands()[*done.menu_entry], state, now);
    if (done.add) run_command(CommandId::add_keys, state, now);
    if (done.keep_blend) run_command(CommandId::keep_blend, state, now);
}

void take_offer(MessageOffer offer, ViewerState& state, double now) {
    if (offer == MessageOffer::landmarks) run_command(CommandId::set_landmarks, state, now);
    if (offer == MessageOffer::timeline) run_command(CommandId::put_on_timeline, state, now);
}

}  // namespace

void apply_to_state(const WindowActions& actions, ViewerState& state, MouseHolds& holds, double now) {
    if (actions.display) state.session.display = *actions.display;
    if (actions.asks_for_unit) run_command(CommandId::set_field_unit, state, now);
    if (actions.panel_sizes) state.appearance.panels = *actions.panel_sizes;
    if (actions.view && actions.view->view_all) state.view_target = ViewTarget::surface;
    if (actions.points_at_notice) state.message.seen = now;
    const MessageOffer offer = state.message.offer;
    if (actions.dismisses_message) state.message.clear();
    if (actions.takes_offer) take_offer(offer, state, now);
    if (actions.wants_domain) run_command(CommandId::new_domain, state, now);
    if (actions.inspector) {
        if (actions.inspector->step) state.node_step = actions.inspector->step;
        if (actions.inspector->is_over) state.inspected.reset();
    }
    if (actions.help) apply_to_help(*actions.help, state);
    state.find_wanted = false;  // the panels have seen it
    state.menu_wanted = false;

    // The domain and the timeline come first, because actions on keys may change their indices.
    holds = {};
    if (actions.brush) {
        holds.brush = actions.brush->hold;
        apply_to_brush(*actions.brush, state, now);
    }
    if (actions.domain) {
        holds.domain = actions.domain->drag;
        apply_to_domain(*actions.domain, state, holds.domain, now);
        holds.domain_menu = actions.domain->menu;
    }
    if (actions.timeline) {
        apply_to_transport(actions.timeline->transport, state, now);
        apply_to_track(actions.timeline->track, state, now);
        holds.time = actions.timeline->track.drag;
    }
    if (actions.blend) apply_to_blend(*actions.blend, state, now);
    if (actions.keys) apply_to_keys(*actions.keys, state, now);
    if (actions.menu.chosen) run_command(commands()[*actions.menu.chosen], state, now);
}

}  // namespace interleaf
