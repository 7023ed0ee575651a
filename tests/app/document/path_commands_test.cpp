// Tests of the commands on the path through the domain.
#include "app/document/path_commands.h"

#include <string>
#include <utility>

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

namespace {

/// A viewer whose path of three points drives.
ViewerState viewer_on_a_path() {
    Family family = sample_family();
    family.path.emplace(std::vector<PathPoint>{{0, {-1, -1}}, {2, {0, 0.5}}, {4, {1, 1}}});
    return ViewerState(with_time_source(std::move(family), TimeSource::path));
}

/// Types \p text into the question that \p state asks.
void answer(ViewerState& state, const std::string& text, double now) {
    const TextQuestion question = *std::exchange(state.question, std::nullopt);
    REQUIRE(question.fault(text).empty());
    question.answer(state, text, now);
}

}  // namespace

TEST_CASE("dragging a path point is one step, and the surface shows the blend at the point") {
    ViewerState state = viewer_on_a_path();
    move_path_point(state, 1, {2, {0.2, 0.3}}, 1);
    move_path_point(state, 1, {2, {0.4, 0.1}}, 2);
    end_drag(state);
    CHECK(state.document.family().path->points()[1].at == glm::dvec2(0.4, 0.1));
    CHECK(state.selected_path_point == 1);
    CHECK(state.session.time() == 2);
    REQUIRE(state.session.point());
    CHECK(state.session.point()->at == glm::dvec2(0.4, 0.1));
    undo(state, 3);
    CHECK(state.document.family().path->points()[1].at == glm::dvec2(0, 0.5));
    CHECK(state.document.undo_step() == nullptr);
}

TEST_CASE("an inserted path point is dragged on in the same step, and removed again") {
    ViewerState state = viewer_on_a_path();
    CHECK(insert_path_point(state, {3, {0.5, 0.7}}, 1));
    CHECK(state.selected_path_point == 2);
    move_path_point(state, 2, {3, {0.6, 0.2}}, 2);
    end_drag(state);
    CHECK(state.document.family().path->points().size() == 4);
    CHECK(*state.document.undo_step() == "Insert a path point");
    remove_path_point(state, 2, 3);
    CHECK(state.document.family().path->points().size() == 3);
    CHECK_FALSE(state.selected_path_point);
    undo(state, 4);
    undo(state, 4);
    CHECK(state.document.undo_step() == nullptr);
    CHECK_FALSE(insert_path_point(state, {2, {0, 0}}, 5));  // a point has that time
}

TEST_CASE("time and place of a path point can be typed, and a point may pass others") {
    ViewerState state = viewer_on_a_path();
    ask_for_path_point_time(state, 1);
    REQUIRE(state.question);
    CHECK(state.question->entry == "2");
    CHECK_FALSE(state.question->fault("soon").empty());
    answer(state, "5.5", 1);
    CHECK(state.document.family().path->end() == 5.5);
    CHECK(state.selected_path_point == 2);
    ask_for_path_point_place(state, 2);
    CHECK(state.question->entry == "0, 0.5");
    for (const char* const fault : {"", "1", "1,", "1, x", "nan, 1", "1, 2, 3"})
        CHECK_FALSE(state.question->fault(fault).empty());
    answer(state, "0.25 -0.5", 2);
    CHECK(state.document.family().path->points()[2] == PathPoint{5.5, {0.25, -0.5}});
    undo(state, 3);
    undo(state, 3);
    CHECK(state.document.undo_step() == nullptr);
}

TEST_CASE("a time that another path point has is refused with a message") {
    ViewerState state = viewer_on_a_path();
    ask_for_path_point_time(state, 1);
    answer(state, "4", 1);
    CHECK(state.message.is_fault());
    CHECK(state.document.undo_step() == nullptr);
}

TEST_CASE("removing all points of the path removes the path, and the selection goes with its point") {
    ViewerState state = viewer_on_a_path();
    for (int i = 0; i < 3; ++i) remove_path_point(state, 0, 1);
    CHECK_FALSE(state.document.family().path);
    undo(state, 2);
    undo(state, 2);
    select_path_point(state, 1, 3);
    undo(state, 4);
    CHECK(state.selected_path_point == 1);
    remove_path(state, 5);
    CHECK_FALSE(state.selected_path_point);
}

TEST_CASE("going from key to key selects the points of the path while the domain is edited") {
    ViewerState state = viewer_on_a_path();
    go_to_key(state, 1, 0);
    CHECK(state.session.time() == 2);
    CHECK_FALSE(state.selected_path_point);
    state.edits_domain = true;
    go_to_key(state, 1, 0);
    CHECK(state.selected_path_point == 2);
    go_to_key(state, -1, 0);
    CHECK(state.selected_path_point == 1);
}

TEST_CASE("the place of a domain vertex is typed, unless a triangle would turn over there") {
    ViewerState state(sample_family());
    ask_for_vertex_place(state, 4);
    REQUIRE(state.question);
    answer(state, "0.25, 0.125", 1);
    CHECK(state.document.family().domain->vertices()[4].at == glm::dvec2(0.25, 0.125));
    CHECK(*state.document.undo_step() == "Set a domain vertex");
    ask_for_vertex_place(state, 4);
    answer(state, "3, 0", 2);
    CHECK(state.message.is_fault());
    CHECK(state.document.family().domain->vertices()[4].at == glm::dvec2(0.25, 0.125));
    ask_for_vertex_place(state, 99);
    CHECK_FALSE(state.question);
}

TEST_CASE("the place of the point is typed") {
    ViewerState state(sample_family());
    ask_for_place(state);
    REQUIRE(state.question);
    answer(state, "0.5,0.25", 1);
    REQUIRE(state.session.point());
    CHECK(state.session.point()->at == glm::dvec2(0.5, 0.25));
    CHECK(state.session.driver() == Driver::point);
}

TEST_CASE("what drives in one run alone changes no document; a choice is an edit, and is what is saved") {
    Family family = sample_family();
    family.path = DomainPath({{0, {-1, -1}}, {4, {1, 1}}});
    family.time_source = TimeSource::keys;
    ViewerState state(std::move(family));
    drive_in_this_run(state, TimeSource::path, 0);
    CHECK(path_drives(state));
    CHECK(state.session.playback().end() == 4);
    CHECK_FALSE(state.document.is_changed());
    CHECK(state.document.undo_step() == nullptr);
    const auto source_to_save = [&] { return state.document.family_to_save()->time_source; };
    CHECK(source_to_save() == TimeSource::keys);
    choose_time_source(state, TimeSource::path, 0);  // it drives already
    CHECK_FALSE(state.document.is_changed());
    CHECK(source_to_save() == TimeSource::keys);
    choose_time_source(state, TimeSource::keys, 0);
    CHECK(state.document.is_changed());
    choose_time_source(state, TimeSource::path, 0);
    CHECK(source_to_save() == TimeSource::path);
    undo(state, 0);
    undo(state, 0);
    CHECK_FALSE(state.document.is_changed());
    CHECK(path_drives(state));
    CHECK(source_to_save() == TimeSource::keys);
    redo(state, 0);
    redo(state, 0);
    CHECK(source_to_save() == TimeSource::path);
}

TEST_CASE("other edits keep what drives in one run out of the files, but a recorded path drives in them") {
    Family family = sample_family();
    family.path = DomainPath({{0, {-1, -1}}, {4, {1, 1}}});
    family.time_source = TimeSource::keys;
    ViewerState state(std::move(family));
    drive_in_this_run(state, TimeSource::path, 0);
    duplicate_key(state, 0);
    smooth_path(state, 0);
    CHECK(state.document.is_changed());
    CHECK(path_drives(state));
    CHECK(state.document.family_to_save()->time_source == TimeSource::keys);
    state.recording.emplace();
    state.recording->points = {{0, {-1, -1}}, {2, {1, 1}}};
    toggle_recording(state, 0);
    CHECK(path_drives(state));
    CHECK(state.document.family_to_save()->time_source == TimeSource::path);
    undo(state, 0);
    remove_path(state, 0);
    CHECK_FALSE(state.document.family_to_save()->path);
    CHECK(state.document.family_to_save()->time_source == TimeSource::keys);
}

TEST_CASE("the place of a key in the domain is typed: that of its vertex, or of a new one") {
    ViewerState state(sample_family());
    ask_for_key_place(state);
    CHECK_FALSE(state.question);  // no key is selected
    state.selected_key = 4;
    CHECK(vertex_of_selected_key(state) == 4);
    ask_for_key_place(state);
    REQUIRE(state.question);
    state.question->answer(state, "0.25, 0.5", 0);
    CHECK(state.document.family().domain->vertices()[4].at == glm::dvec2(0.25, 0.5));

    state.selected_key = 4;
    duplicate_key(state, 0);
    state.selected_key = 5;
    CHECK_FALSE(vertex_of_selected_key(state));
    ask_for_key_place(state);
    REQUIRE(state.question);
    CHECK(state.question->fault(state.question->entry).empty());
    state.question->answer(state, state.question->entry, 0);
    REQUIRE(state.document.family().domain->vertices().size() == 6);
    CHECK(state.document.family().domain->vertices()[5].at == glm::dvec2(1.5, 0));
    CHECK(vertex_of_selected_key(state) == 5);
}
