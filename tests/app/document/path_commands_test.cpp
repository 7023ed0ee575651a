// Tests of the commands on the path through the domain.
#include "app/document/path_commands.h"

#include <doctest/doctest.h>

#include "app/document/edit_commands.h"
#include "app/document/playback_commands.h"
#include "app/sample_family.h"
#include "family/family_time.h"

using namespace interleaf;

namespace {

/// Drags the point along the diagonal of the domain from wall time 10 to 12.
void drag_diagonally(ViewerState& state) {
    for (int frame = 0; frame <= 120; ++frame) {
        const double part = frame / 120.0;
        state.session.move_point({2 * part - 1, 2 * part - 1}, 10 + 2 * part);
        record_point(state, 10 + 2 * part);
    }
}

}  // namespace

TEST_CASE("a recorded drag becomes a path of few points that drives, in one undoable step") {
    ViewerState state(sample_family());
    toggle_recording(state, 9);
    CHECK(state.recording);
    drag_diagonally(state);
    toggle_recording(state, 13);
    CHECK_FALSE(state.recording);
    REQUIRE(state.document.family().path);
    const DomainPath& path = *state.document.family().path;
    CHECK(path.points().size() == 2);
    CHECK(path.begin() == 0);
    CHECK(path.end() == doctest::Approx(2));
    CHECK(path_drives(state));
    CHECK(state.session.driver() == Driver::timeline);
    CHECK(state.session.time() == 0);
    state.session.seek(1, 14);
    REQUIRE(state.session.point());
    CHECK(state.session.point()->at.x == doctest::Approx(0));
    undo(state, 15);
    CHECK_FALSE(state.document.family().path);
    CHECK_FALSE(path_drives(state));
}

TEST_CASE("a recording without a drag changes nothing, and drags outside a recording are not recorded") {
    ViewerState state(sample_family());
    drag_diagonally(state);
    toggle_recording(state, 9);
    toggle_recording(state, 10);
    CHECK_FALSE(state.document.family().path);
    CHECK(state.document.undo_step() == nullptr);
}

TEST_CASE("keys or the path drive by choice, and removing the path lets the keys drive") {
    ViewerState state(sample_family());
    toggle_recording(state, 9);
    drag_diagonally(state);
    toggle_recording(state, 13);
    toggle_time_source(state, 13);
    CHECK_FALSE(path_drives(state));
    CHECK(state.session.playback().end() == 5);
    toggle_time_source(state, 13);
    CHECK(path_drives(state));
    CHECK(state.session.playback().end() == doctest::Approx(2));
    smooth_path(state, 13);
    CHECK(*state.document.undo_step() == "Smooth the path");
    remove_path(state, 13);
    CHECK_FALSE(state.document.family().path);
    CHECK(state.session.playback().end() == 5);
}

TEST_CASE("a family with a path alone plays it") {
    Family family = sample_family();
    family.timeline.reset();
    family.path.emplace(std::vector<PathPoint>{{0, {-1, -1}}, {4, {1, 1}}});
    ViewerState state(family);
    CHECK(state.session.has_time());
    state.session.toggle_playing(0);
    state.session.advance(1);
    CHECK(state.session.is_playing());
    CHECK(state.session.time() == 1);
    CHECK_FALSE(state.session.next_key_sets().empty());
}

TEST_CASE("a rest while recording is a rest of the path") {
    ViewerState state(sample_family());
    toggle_recording(state, 0);
    const auto move_to = [&](double x, double now) {
        state.session.move_point({x, 0}, now);
        record_point(state, now);
    };
    move_to(-1, 0);
    move_to(0, 0.05);
    move_to(1, 4);
    toggle_recording(state, 5);
    REQUIRE(state.document.family().path);
    CHECK(state.document.family().path->at(3.9).x == doctest::Approx(0));
}

TEST_CASE("a recording ends with its domain") {
    ViewerState state(sample_family());
    toggle_recording(state, 0);
    drag_diagonally(state);
    edit(
        state, "Remove the domain", [](const Family& family) { return with_domain(family, std::nullopt); },
        13);
    CHECK_FALSE(state.recording);
    toggle_recording(state, 14);
    CHECK_FALSE(state.recording);
}

TEST_CASE("while the path drives, no key is put on the hidden timeline or taken off it") {
    ViewerState state(sample_family());
    toggle_recording(state, 9);
    drag_diagonally(state);
    toggle_recording(state, 13);
    state.session.seek(0, 14);
    state.selected_key = 1;
    const Timeline before = *state.document.family().timeline;
    CHECK_FALSE(has_present_time(state));
    remove_present_time(state, 14);
    add_present_time(state, 14);
    CHECK(*state.document.family().timeline == before);
}
