#include "app/document/edit_commands.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/core.h>

#include "family/domain_edits.h"
#include "family/family_fields.h"
#include "family/family_time.h"
#include "family/field_units.h"
#include "family/key_edits.h"
#include "family/names.h"
#include "family/new_family.h"
#include "family/origin.h"
#include "family/synchronize_keys.h"
#include "hierarchy/error.h"
#include "hierarchy/morph.h"
#include "text/parsed_number.h"

namespace interleaf {

namespace {

const std::string& name_of(const ViewerState& state, std::size_t key) {
    return state.document.family().keys[key].name;
}

/// Updates session and selection to the document's present state.
template <typename Change>
void change_document(ViewerState& state, double now, Change change) {
    std::optional<Key> selected;
    if (state.selected_key) selected = state.document.family().keys[*state.selected_key];
    change();
    state.brush.report.clear();
    if (selected)
        state.selected_key = place_after_change(state.document.family().keys, *selected, *state.selected_key);
    if (!state.document.family().domain) state.recording.reset();
    const auto& path = state.document.family().path;
    if (!path || state.selected_path_point >= path->points().size()) state.selected_path_point.reset();
    state.session.replace_family(state.document.snapshot(), now);
}

std::optional<double> time_in(const std::string& text) {
    const std::optional<double> time = parsed_number<double>(text);
    return time && std::isfinite(*time) ? time : std::nullopt;
}

/// The time as text, without digits that come from rounding: 1.39 rather than 1.3900000000000001.
std::string time_text(double time) {
    return fmt::format("{:.10g}", time);
}

/// The question for the time of \p key on the timeline.
std::string time_question(const ViewerState& state, const std::string& key) {
    const Family& family = state.document.family();
    if (!family.time_unit.empty())
        return fmt::format("Time of {} on the timeline, in {}", key, family.time_unit);
    return family.timeline && family.timeline->unit() == TimeUnit::steps
               ? fmt::format("Step of {} on the timeline", key)
               : fmt::format("Time of {} on the timeline, in seconds", key);
}

std::string fault_of_time(const std::string& text) {
    return time_in(text) ? "" : "a number, such as 2.5";
}

}  // namespace

void edit(ViewerState& state, std::string step, const FamilyChange& change, double now) {
    end_drag(state);
    try {
        Family family = change(state.document.family());
        change_document(state, now, [&] { state.document.edit(std::move(step), std::move(family)); });
    } catch (const InputError& error) {
        state.message = message_of(error);
    }
}

void drag_edit(ViewerState& state, std::string step, const FamilyChange& change, double now) {
    try {
        Family family = change(state.document.family());
        change_document(state, now, [&] {
            if (state.is_dragging) {
                state.document.amend(std::move(family));
            } else {
                state.document.edit(std::move(step), std::move(family));
            }
        });
        state.is_dragging = true;
    } catch (const InputError&) {
        return;  // the pointer is at an invalid place: keep the state
    }
}

void end_drag(ViewerState& state) {
    state.is_dragging = false;
}

void cancel_drag(ViewerState& state, double now) {
    if (!state.is_dragging) return;
    end_drag(state);
    change_document(state, now, [&] { state.document.retract(); });
}

void undo(ViewerState& state, double now) {
    end_drag(state);
    change_document(state, now, [&] { state.document.undo(); });
}

void redo(ViewerState& state, double now) {
    end_drag(state);
    change_document(state, now, [&] { state.document.redo(); });
}

void keep_blend(ViewerState& state, double now) {
    const Weights weights = state.session.weights();
    const auto change = [&](const Family& family) {
        UnionMesh mesh = unite(family, weights);
        unite_fields(family, weights, mesh);
        set_blend(mesh, family.blend);
        return with_key_added(family, {"blend", morphed_hierarchy(mesh, weight_values(weights))});
    };
    const std::size_t count = state.document.family().keys.size();
    edit(state, "Keep blend", change, now);
    if (state.document.family().keys.size() > count) state.selected_key = count;
}

void add_keys(ViewerState& state, const Family& added, double now) {
    const std::string step = added.keys.size() == 1 ? fmt::format("Add {}", added.keys.front().name)
                                                    : fmt::format("Add {} keys", added.keys.size());
    edit(
        state, step,
        [&](const Family& family) {
            Family result = family;
            std::vector<Key> keys = added.keys;
            move_origin(keys, added.origin, family.origin);
            result.field_scales = adopt_scales(family, keys, added.field_scales);
            for (Key& key : keys) {
                key.name = unused_name(result, key.name);
                result.keys.push_back(std::move(key));
            }
            const Synchronization synchronization = synchronize(result.keys);
            if (!synchronization.mismatches.empty()) {
                const KeyMismatch& mismatch = synchronization.mismatches.front();
                throw MismatchError(mismatch.text, result.keys, mismatch);
            }
            for (const LandmarkDirection& landmark : added.landmarks)
                if (std::ranges::find(result.landmarks, landmark.name, &LandmarkDirection::name) ==
                    result.landmarks.end())
                    result.landmarks.push_back(landmark);
            return result;
        },
        now);
}

void duplicate_key(ViewerState& state, double now) {
    if (!state.selected_key) return;
    const std::size_t key = *state.selected_key;
    edit(
        state, fmt::format("Duplicate {}", name_of(state, key)),
        [&](const Family& family) { return with_key_duplicated(family, key); }, now);
}

void remove_key(ViewerState& state, double now) {
    if (!state.selected_key) return;
    const std::size_t key = *state.selected_key;
    edit(
        state, fmt::format("Remove {}", name_of(state, key)),
        [&](const Family& family) { return with_key_removed(family, key); }, now);
}

void move_key(ViewerState& state, std::size_t to, double now) {
    if (!state.selected_key) return;
    const std::size_t from = *state.selected_key;
    if (from == to || to >= state.document.family().keys.size()) return;
    edit(
        state, fmt::format("Move {}", name_of(state, from)),
        [&](const Family& family) { return with_key_moved(family, from, to); }, now);
}

void ask_for_key_name(ViewerState& state) {
    if (!state.selected_key) return;
    const std::size_t key = *state.selected_key;
    const std::string old_name = name_of(state, key);
    state.question = TextQuestion{
        .text = fmt::format("Rename {}", old_name),
        .entry = old_name,
        .button = "Rename",
        .fault = [&state, key](const std::string& name) -> std::string {
            try {
                with_key_renamed(state.document.family(), key, name);
            } catch (const InputError& error) {
                return error.what();
            }
            return "";
        },
        .answer =
            [key, old_name](ViewerState& changed, const std::string& name, double now) {
                if (name == old_name) return;
                edit(
                    changed, fmt::format("Rename {}", old_name),
                    [&](const Family& family) { return with_key_renamed(family, key, name); }, now);
            }};
}

void ask_for_family_name(ViewerState& state) {
    const std::string old_name = state.document.family().name;
    state.question = TextQuestion{
        .text = "Rename the family",
        .entry = old_name,
        .button = "Rename",
        .fault = [](const std::string& name) -> std::string { return fault_of_name(name, "a family"); },
        .answer =
            [old_name](ViewerState& changed, const std::string& name, double now) {
                if (name == old_name) return;
                edit(
                    changed, "Rename family",
                    [&](const Family& family) { return with_family_renamed(family, name); }, now);
            }};
}

void ask_for_new_time(ViewerState& state) {
    if (!state.selected_key) return;
    const std::size_t key = *state.selected_key;
    const auto& timeline = state.document.family().timeline;
    state.question = TextQuestion{.text = time_question(state, name_of(state, key)),
                                  .entry = time_text(timeline ? timeline->end() + 1 : 0),
                                  .button = "Put there",
                                  .fault = fault_of_time,
                                  .answer = [key](ViewerState& changed, const std::string& text, double now) {
                                      add_time(changed, key, time_in(text).value_or(0), now);
                                  }};
}

void ask_for_time(ViewerState& state, std::size_t place) {
    const TimelineKey entry = state.document.family().timeline->keys()[place];
    const std::string name = name_of(state, entry.key);
    state.question =
        TextQuestion{.text = time_question(state, name),
                     .entry = time_text(entry.time),
                     .button = "Set",
                     .fault = fault_of_time,
                     .answer = [=](ViewerState& changed, const std::string& text, double now) {
                         if (text == time_text(entry.time))
                             return;  // unchanged, although the text may be rounded
                         const double time = time_in(text).value_or(entry.time);
                         if (time == entry.time) return;
                         edit(
                             changed, fmt::format("Set the time of {}", name),
                             [&](const Family& family) { return with_time_moved(family, place, time); }, now);
                     }};
}

void add_time(ViewerState& state, std::size_t key, double time, double now) {
    edit(
        state, fmt::format("Put {} on the timeline", name_of(state, key)),
        [&](const Family& family) { return with_time_added(family, key, time); }, now);
}

void remove_time(ViewerState& state, std::size_t place, double now) {
    const std::size_t key = state.document.family().timeline->keys()[place].key;
    edit(
        state, fmt::format("Take {} off the timeline", name_of(state, key)),
        [&](const Family& family) { return with_time_removed(family, place); }, now);
}

void make_domain(ViewerState& state, double now) {
    edit(
        state, "New domain",
        [](const Family& family) {
            std::optional<ParameterDomain> domain = family_of_keys(family.name, family.keys).domain;
            if (!domain)
                throw InputError("a new domain takes three to nine keys; add further keys to it afterwards");
            return with_domain(family, std::move(domain));
        },
        now);
}

void add_domain_vertex(ViewerState& state, glm::dvec2 at, std::size_t key, double snap, double now) {
    edit(
        state, fmt::format("Put {} in the domain", name_of(state, key)),
        [&](const Family& family) {
            return with_domain(family, with_vertex_added(*family.domain, at, key, snap));
        },
        now);
}

void remove_domain_vertex(ViewerState& state, Index vertex, double now) {
    edit(
        state, "Remove a domain vertex",
        [&](const Family& family) { return with_domain(family, without_vertex(*family.domain, vertex)); },
        now);
}

void set_domain_vertex_key(ViewerState& state, Index vertex, std::size_t key, double now) {
    if (state.document.family().domain->vertices()[vertex].key == key) return;
    edit(
        state, fmt::format("Put {} on a domain vertex", name_of(state, key)),
        [&](const Family& family) {
            return with_domain(family, with_vertex_key(*family.domain, vertex, key));
        },
        now);
}

void select_key(ViewerState& state, std::size_t key, double now) {
    state.selected_key = key;
    state.session.show_key(key, now);
}

}  // namespace interleaf
