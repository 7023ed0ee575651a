#include "app/document/path_commands.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/core.h>
#include <glm/geometric.hpp>

#include "app/document/edit_commands.h"
#include "family/family_time.h"
#include "text/parsed_number.h"

namespace interleaf {

namespace {

/// Tolerance of a recorded path, as a fraction of the diagonal of the domain's box.
constexpr double recording_tolerance = 0.004;

/// The shortest time between two recorded points, whose times are multiples of it; seconds.
constexpr double min_interval = 1e-3;

/// A longer time between two recorded points is a rest; seconds.
constexpr double longest_motion = 0.1;

/// A place of the domain in \p text: "0.25, -0.5"; a blank suffices between the numbers.
std::optional<glm::dvec2> place_in(std::string_view text) {
    const std::size_t gap = text.find_first_of(", ;");
    if (gap == std::string_view::npos) return std::nullopt;
    const std::size_t second = text.find_first_not_of(", ;", gap);
    if (second == std::string_view::npos) return std::nullopt;
    const auto u = parsed_number<double>(text.substr(0, gap));
    const auto v = parsed_number<double>(text.substr(second));
    if (!u || !v || !std::isfinite(*u) || !std::isfinite(*v)) return std::nullopt;
    return glm::dvec2(*u, *v);
}

std::string fault_of_place(const std::string& text) {
    return place_in(text) ? "" : "two numbers, such as 0.25, -0.5";
}

std::string place_text(glm::dvec2 at) {
    return fmt::format("{:.10g}, {:.10g}", at.x, at.y);
}

/// The path's point \p place; null if there is none.
const PathPoint* path_point(const ViewerState& state, std::size_t place) {
    const auto& path = state.document.family().path;
    return path && place < path->points().size() ? &path->points()[place] : nullptr;
}

/// Sets the point \p place as one step, and selects it.
void set_path_point(ViewerState& state, std::size_t place, const PathPoint& to, double now) {
    edit(
        state, "Set a path point",
        [&](const Family& family) { return with_path(family, family.path->with_point_moved(place, to)); },
        now);
    const auto points = state.document.family().path->points();
    const auto moved = std::ranges::find(points, to);
    if (moved != points.end())
        select_path_point(state, static_cast<std::size_t>(moved - points.begin()), now);
}

}  // namespace

void toggle_recording(ViewerState& state, double now) {
    if (!state.recording) {
        if (state.document.family().domain) state.recording.emplace();
        return;
    }
    const PathRecording recording = *std::exchange(state.recording, std::nullopt);
    if (recording.points.size() < 2 || !state.document.family().domain) return;
    const DomainBox box = box_of(state.document.family().domain->vertices());
    const auto before = state.document.snapshot();
    const double tolerance = recording_tolerance * glm::distance(box.low, box.high);
    edit(
        state, "Record a path",
        [&](const Family& family) {
            const DomainPath path = simplified(DomainPath(recording.points), tolerance);
            return with_time_source(with_path(family, path), TimeSource::path);
        },
        now);
    if (state.document.snapshot() != before) state.document.keep_time_source();
    state.session.seek(0, now);
}

void record_point(ViewerState& state, double now) {
    if (!state.recording || !state.session.point()) return;
    PathRecording& recording = *state.recording;
    if (!recording.begin) recording.begin = now;
    const double time = std::round((now - *recording.begin) * 1000) / 1000;
    const bool is_too_soon =
        !recording.points.empty() && time < recording.points.back().time + min_interval / 2;
    if (is_too_soon || recording.points.size() + 2 > DomainPath::max_points) return;
    // While the mouse rests, no points come. The path rests, too, until just before it moves again.
    if (!recording.points.empty() && time > recording.points.back().time + longest_motion)
        recording.points.push_back({time - min_interval, recording.points.back().at});
    recording.points.push_back({time, state.session.point()->at});
}

void drive_in_this_run(ViewerState& state, TimeSource source, double now) {
    if (source_of_time(state.document.family()) == source) return;
    state.document.drive_in_this_run(source);
    state.session.replace_family(state.document.snapshot(), now);
    state.session.seek(state.session.time(), now);
}

void choose_time_source(ViewerState& state, TimeSource source, double now) {
    if (source_of_time(state.document.family()) == source) return;
    edit(
        state, source == TimeSource::path ? "Follow the path" : "Follow the keys",
        [&](const Family& family) { return with_time_source(family, source); }, now);
    if (source_of_time(state.document.family()) == source) state.document.keep_time_source();
    state.session.seek(state.session.time(), now);
}

void toggle_time_source(ViewerState& state, double now) {
    choose_time_source(state, path_drives(state) ? TimeSource::keys : TimeSource::path, now);
}

bool path_drives(const ViewerState& state) {
    return source_of_time(state.document.family()) == TimeSource::path;
}

void smooth_path(ViewerState& state, double now) {
    if (!state.document.family().path) return;
    edit(
        state, "Smooth the path",
        [](const Family& family) {
            const double duration = family.path->end() - family.path->begin();
            return with_path(family, smoothed(*family.path, duration / 50));
        },
        now);
}

void remove_path(ViewerState& state, double now) {
    if (!state.document.family().path) return;
    edit(
        state, "Remove the path", [](const Family& family) { return with_path(family, std::nullopt); }, now);
}

void select_path_point(ViewerState& state, std::size_t place, double now) {
    const PathPoint* const point = path_point(state, place);
    if (point == nullptr) return;
    state.selected_path_point = place;
    if (path_drives(state)) state.session.seek(point->time, now);
}

void move_path_point(ViewerState& state, std::size_t place, const PathPoint& to, double now) {
    if (path_point(state, place) == nullptr) return;
    drag_edit(
        state, "Move a path point",
        [&](const Family& family) { return with_path(family, family.path->with_point_moved(place, to)); },
        now);
    select_path_point(state, place, now);
}

bool insert_path_point(ViewerState& state, const PathPoint& added, double now) {
    if (!state.document.family().path) return false;
    drag_edit(
        state, "Insert a path point",
        [&](const Family& family) { return with_path(family, family.path->with_point(added)); }, now);
    const auto points = state.document.family().path->points();
    const auto inserted = std::ranges::find(points, added);
    if (inserted == points.end()) return false;
    select_path_point(state, static_cast<std::size_t>(inserted - points.begin()), now);
    return true;
}

void remove_path_point(ViewerState& state, std::size_t place, double now) {
    if (path_point(state, place) == nullptr) return;
    edit(
        state, "Remove a path point",
        [&](const Family& family) { return with_path(family, family.path->without_point(place)); }, now);
    state.selected_path_point.reset();
}

void ask_for_path_point_time(ViewerState& state, std::size_t place) {
    const PathPoint* const point = path_point(state, place);
    if (point == nullptr) return;
    state.question = TextQuestion{
        .text = "Time of the path point, in seconds",
        .entry = fmt::format("{:.10g}", point->time),
        .button = "Set",
        .fault =
            [](const std::string& typed) {
                const auto time = parsed_number<double>(typed);
                return time && std::isfinite(*time) ? std::string() : "a number of seconds, such as 2.5";
            },
        .answer =
            [place](ViewerState& changed, const std::string& typed, double now) {
                const PathPoint* const old = path_point(changed, place);
                const auto time = parsed_number<double>(typed);
                if (old != nullptr && time) set_path_point(changed, place, {*time, old->at}, now);
            }};
}

void ask_for_path_point_place(ViewerState& state, std::size_t place) {
    const PathPoint* const point = path_point(state, place);
    if (point == nullptr) return;
    state.question =
        TextQuestion{.text = "Place of the path point, U, V",
                     .entry = place_text(point->at),
                     .button = "Set",
                     .fault = fault_of_place,
                     .answer = [place](ViewerState& changed, const std::string& typed, double now) {
                         const PathPoint* const old = path_point(changed, place);
                         const auto at = place_in(typed);
                         if (old != nullptr && at) set_path_point(changed, place, {old->time, *at}, now);
                     }};
}

void ask_for_place(ViewerState& state) {
    if (!state.document.family().domain) return;
    state.question = TextQuestion{.text = "Place of the point, U, V",
                                  .entry = state.session.point() ? place_text(state.session.point()->at) : "",
                                  .button = "Set",
                                  .fault = fault_of_place,
                                  .answer = [](ViewerState& changed, const std::string& typed, double now) {
                                      const auto at = place_in(typed);
                                      if (!at || !changed.document.family().domain) return;
                                      changed.session.move_point(*at, now);
                                      record_point(changed, now);
                                  }};
}

void ask_for_vertex_place(ViewerState& state, Index vertex) {
    const auto& domain = state.document.family().domain;
    if (!domain || vertex >= domain->vertices().size()) return;
    state.question =
        TextQuestion{.text = "Place of the vertex, U, V",
                     .entry = place_text(domain->vertices()[vertex].at),
                     .button = "Set",
                     .fault = fault_of_place,
                     .answer = [vertex](ViewerState& changed, const std::string& typed, double now) {
                         const auto at = place_in(typed);
                         const auto& present = changed.document.family().domain;
                         if (!at || !present || vertex >= present->vertices().size()) return;
                         edit(
                             changed, "Set a domain vertex",
                             [&](const Family& family) {
                                 return with_domain(family, family.domain->with_vertex_at(vertex, *at));
                             },
                             now);
                     }};
}

std::optional<Index> vertex_of_selected_key(const ViewerState& state) {
    const auto& domain = state.document.family().domain;
    if (!domain || !state.selected_key) return std::nullopt;
    const auto& vertices = domain->vertices();
    const auto found = std::ranges::find(vertices, *state.selected_key, &DomainVertex::key);
    if (found == vertices.end()) return std::nullopt;
    return static_cast<Index>(found - vertices.begin());
}

void ask_for_key_place(ViewerState& state) {
    const Family& family = state.document.family();
    if (!family.domain || !state.selected_key) return;
    if (const auto vertex = vertex_of_selected_key(state)) return ask_for_vertex_place(state, *vertex);
    const DomainBox box = box_of(family.domain->vertices());
    const glm::dvec2 size = box.high - box.low;
    const glm::dvec2 beside(box.high.x + size.x / 4, (box.low.y + box.high.y) / 2);
    const double snap = 1e-6 * glm::length(size);
    state.question = TextQuestion{
        .text = fmt::format("Place of {} in the domain, U, V", family.keys[*state.selected_key].name),
        .entry = place_text(beside),
        .button = "Put there",
        .fault = fault_of_place,
        .answer = [key = *state.selected_key, snap](ViewerState& changed, const std::string& typed,
                                                    double now) {
            if (const auto at = place_in(typed)) add_domain_vertex(changed, *at, key, snap, now);
        }};
}

void go_to_key(ViewerState& state, int direction, double now) {
    state.session.seek_key(direction, now);
    if (!state.edits_domain || !path_drives(state)) return;
    const auto points = state.document.family().path->points();
    const auto here = std::ranges::find(points, state.session.time(), &PathPoint::time);
    if (here != points.end()) state.selected_path_point = static_cast<std::size_t>(here - points.begin());
}

}  // namespace interleaf
