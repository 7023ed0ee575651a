#include "app/document/path_commands.h"

#include <cmath>
#include <utility>

#include <glm/geometric.hpp>

#include "app/document/edit_commands.h"
#include "family/family_time.h"

namespace interleaf {

namespace {

/// Tolerance of a recorded path, as a fraction of the diagonal of the domain's box.
constexpr double recording_tolerance = 0.004;

/// The shortest time between two recorded points, whose times are multiples of it; seconds.
constexpr double min_interval = 1e-3;

/// A longer time between two recorded points is a rest; seconds.
constexpr double longest_motion = 0.1;

}  // namespace

void toggle_recording(ViewerState& state, double now) {
    if (!state.recording) {
        if (state.document.family().domain) state.recording.emplace();
        return;
    }
    const PathRecording recording = *std::exchange(state.recording, std::nullopt);
    if (recording.points.size() < 2 || !state.document.family().domain) return;
    const DomainBox box = box_of(state.document.family().domain->vertices());
    const double tolerance = recording_tolerance * glm::distance(box.low, box.high);
    edit(
        state, "Record a path",
        [&](const Family& family) {
            const DomainPath path = simplified(DomainPath(recording.points), tolerance);
            return with_time_source(with_path(family, path), TimeSource::path);
        },
        now);
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

void choose_time_source(ViewerState& state, TimeSource source, double now) {
    if (source_of_time(state.document.family()) == source) return;
    edit(
        state, source == TimeSource::path ? "Follow the path" : "Follow the keys",
        [&](const Family& family) { return with_time_source(family, source); }, now);
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

}  // namespace interleaf
