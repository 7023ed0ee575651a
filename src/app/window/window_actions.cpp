#include "app/window/window_actions.h"

#include "app/document/edit_commands.h"
#include "app/window/commands.h"
#include "family/domain_edits.h"
#include "family/key_edits.h"

namespace interleaf {

namespace {

void apply_to_domain(const ParameterDomainResult& done, ViewerState& state, double now) {
    if (done.moved_to) state.session.move_point(*done.moved_to, now);
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
    if (done.removed) remove_domain_vertex(state, *done.removed, now);
}

void apply_to_timeline(const TimelineResult& done, ViewerState& state, double now) {
    Session& session = state.session;
    if (done.seek_to) session.seek(*done.seek_to, now);
    if (done.toggle_playing) session.toggle_playing(now);
    if (done.toggle_loop) session.toggle_loop(now);
    if (const auto& moved = done.moved) {
        drag_edit(
            state, "Move a key in time",
            [&](const Family& before) { return with_time_moved(before, moved->place, moved->to); }, now);
    }
    if (done.added) add_time(state, done.added->key, done.added->time, now);
    if (done.asked_time) ask_for_time(state, *done.asked_time);
    if (done.removed) remove_time(state, *done.removed, now);
}

void apply_to_keys(const KeysPanelResult& done, ViewerState& state, double now) {
    if (done.chosen) select_key(state, *done.chosen, now);
    if (done.renamed) ask_for_key_name(state);
    if (done.dragged) {
        state.selected_key = done.dragged;
        move_key(state, done.dropped_on, now);
    }
    if (done.menu_entry) run_command(*key_commands()[*done.menu_entry], state, now);
    if (done.add) run_command(CommandId::add_keys, state, now);
    if (done.keep_blend) run_command(CommandId::keep_blend, state, now);
}

}  // namespace

void apply_to_state(const WindowActions& actions, ViewerState& state, MouseHolds& holds, double now) {
    if (actions.display) state.session.display = *actions.display;
    if (actions.view && actions.view->view_all) state.view_target = ViewTarget::surface;
    if (actions.points_at_notice) state.message.seen = now;
    if (actions.dismisses_message) state.message.clear();
    if (actions.closes_help) state.help_shown = false;

    // The domain and the timeline come first, because actions on keys may change their indices.
    holds = {};
    if (actions.domain) {
        apply_to_domain(*actions.domain, state, now);
        holds.domain = actions.domain->drag;
        holds.domain_menu = actions.domain->menu;
    }
    if (actions.timeline) {
        apply_to_timeline(*actions.timeline, state, now);
        holds.time = actions.timeline->drag;
    }
    if (actions.keys) apply_to_keys(*actions.keys, state, now);
    if (actions.menu.chosen) run_command(commands()[*actions.menu.chosen], state, now);
}

}  // namespace interleaf
