#include "app/window/document_panels.h"

#include <algorithm>
#include <array>
#include <string_view>

#include <fmt/core.h>

#include "app/document/edit_commands.h"
#include "family/domain_edits.h"
#include "family/key_edits.h"
#include "ui/panels/parameter_domain_panel.h"
#include "ui/panels/timeline_panel.h"

namespace interleaf {

namespace {

/// The points that the timeline passes in the domain.
std::vector<glm::dvec2> path_through_domain(const Family& family) {
    std::vector<glm::dvec2> path;
    if (!family.timeline || !family.domain) return path;
    for (const TimelineKey& key : family.timeline->keys()) {
        if (const auto at = family.domain->point_of(family.timeline->at(key.time))) path.push_back(*at);
    }
    return path;
}

/// The commands about the selected key.
std::vector<const Command*> key_commands() {
    std::vector<const Command*> selected;
    for (const Command& command : commands())
        if (command.menu == "Key" && command.is_enabled != nullptr) selected.push_back(&command);
    return selected;
}

const char* remark_of(Driver driver) {
    return driver == Driver::key
               ? "One key is shown alone: scrub or press Space to follow the timeline again"
               : "Point moved off the timeline's path: scrub or press Space to follow it again";
}

}  // namespace

MenuEntry menu_entry(const Command& command, const ViewerState& state) {
    return {.menu = command.menu,
            .name = command.label != nullptr ? command.label(state) : std::string(command.name),
            .shortcut = shortcut_text(command),
            .description = command.description,
            .on = command.is_on != nullptr && command.is_on(state),
            .enabled = is_enabled(command, state)};
}

KeysPanelResult show_keys(ViewerState& state, const std::vector<KeyPortrait>& portraits, float height,
                          double now) {
    const auto& keys = state.document.family().keys;
    std::vector<KeyRow> rows;
    for (std::size_t key = 0; key < std::min(keys.size(), portraits.size()); ++key) {
        rows.push_back({.name = keys[key].name,
                        .leaves = portraits[key].leaves,
                        .deepest = portraits[key].deepest,
                        .picture = portraits[key].picture.name()});
    }
    const std::vector<const Command*> menu = key_commands();
    std::vector<MenuEntry> entries;
    entries.reserve(menu.size());
    for (const Command* const command : menu) entries.push_back(menu_entry(*command, state));

    const KeysPanelResult result = keys_panel(
        {.keys = rows, .weights = state.session.weights(), .selected = state.selected_key, .menu = entries},
        height);
    if (result.chosen) select_key(state, *result.chosen, now);
    if (result.renamed) ask_for_key_name(state);
    if (result.menu_entry) run_command(*menu[*result.menu_entry], state, now);
    if (result.add) run_command(command_named("Add keys"), state, now);
    if (result.keep_blend) run_command(command_named("Keep blend"), state, now);
    if (result.dragged) {
        state.selected_key = result.dragged;
        move_key(state, result.dropped_on, now);
    }
    return result;
}

Rect show_domain(ViewerState& state, double now) {
    const Family& family = state.document.family();
    const std::vector<glm::dvec2> path = path_through_domain(family);
    const ParameterDomainResult result = parameter_domain_panel(
        family, {.point = state.session.point(), .path = path, .edits = state.edits_domain});
    if (result.moved_to) state.session.move_point(*result.moved_to, now);
    if (const auto& moved = result.moved_vertex) {
        drag_edit(
            state, "Move a domain vertex",
            [&](const Family& before) {
                Family after = before;
                after.domain = with_vertex_moved(*before.domain, moved->vertex, moved->to);
                return after;
            },
            now);
    }
    if (result.added) add_domain_vertex(state, result.added->at, result.added->key, result.snap, now);
    if (result.assigned) set_domain_vertex_key(state, result.assigned->vertex, result.assigned->key, now);
    if (result.removed) remove_domain_vertex(state, *result.removed, now);
    return result.plot;
}

Rect show_timeline(ViewerState& state, const Rect& rect, double now) {
    Session& session = state.session;
    const TimelineResult result = timeline_panel(rect, state.document.family(),
                                                 {.time = session.time(),
                                                  .playing = session.is_playing(),
                                                  .loops = session.loops(),
                                                  .drives = session.driver() == Driver::timeline,
                                                  .remark = remark_of(session.driver())});
    if (result.seek_to) session.seek(*result.seek_to, now);
    if (result.toggle_playing) session.toggle_playing(now);
    if (result.toggle_loop) session.toggle_loop(now);
    if (const auto& moved = result.moved) {
        drag_edit(
            state, "Move a key in time",
            [&](const Family& before) { return with_time_moved(before, moved->place, moved->to); }, now);
    }
    if (result.added) add_time(state, result.added->key, result.added->time, now);
    if (result.asked_time) ask_for_time(state, *result.asked_time);
    if (result.removed) remove_time(state, *result.removed, now);
    return result.track;
}

}  // namespace interleaf
