// Tests of the commands of playback: questions with their limits, in and out points, and the interpolation as
// an undoable edit.
#include "app/document/playback_commands.h"

#include <string>

#include <doctest/doctest.h>

#include "app/document/edit_commands.h"
#include "app/sample_family.h"

using namespace interleaf;

namespace {

/// Enters \p text into the question of \p state.
void answer(ViewerState& state, const std::string& text) {
    REQUIRE(state.question);
    REQUIRE(state.question->fault(text).empty());
    const TextQuestion question = *state.question;
    question.answer(state, text, 0);
}

std::string fault(const ViewerState& state, const std::string& text) {
    REQUIRE(state.question);
    return state.question->fault(text);
}

}  // namespace

TEST_CASE("a speed can be typed as a number or as a quotient, within the limits") {
    ViewerState state(sample_family());
    ask_for_speed(state);
    answer(state, "1/16");
    CHECK(state.session.playback().speed() == 1.0 / 16);
    for (const char* const wrong : {"", "x", "0", "9", "1/0", "1/65", "-1", "1/2/3"})
        CHECK_FALSE(fault(state, wrong).empty());
}

TEST_CASE("the speed doubles and halves, and a typed one goes to the next power of two") {
    ViewerState state(sample_family());
    const auto speed = [&] { return state.session.playback().speed(); };
    change_speed(state, -1, 0);
    CHECK(speed() == 0.5);
    state.session.set_speed(0.3, 0);
    change_speed(state, 1, 0);
    CHECK(speed() == 0.5);
    state.session.set_speed(0.3, 0);
    change_speed(state, -1, 0);
    CHECK(speed() == 0.25);
    for (int i = 0; i < 20; ++i) change_speed(state, -1, 0);
    CHECK(speed() == min_speed);
    for (int i = 0; i < 20; ++i) change_speed(state, 1, 0);
    CHECK(speed() == max_speed);
}

TEST_CASE("a typed time is within the timeline") {
    ViewerState state(sample_family());
    ask_for_present_time(state);
    answer(state, "2.5");
    CHECK(state.session.time() == 2.5);
    CHECK_FALSE(fault(state, "5.1").empty());
    CHECK_FALSE(fault(state, "-0.1").empty());
}

TEST_CASE("an in point behind the out point takes it to the end, and the other way round") {
    ViewerState state(sample_family());
    set_in_point(state, 1, 0);
    set_out_point(state, 3, 0);
    CHECK(state.session.playback().range() == TimeRange{1, 3});
    set_in_point(state, 4, 0);
    CHECK(state.session.playback().range() == TimeRange{4, 5});
    set_out_point(state, 2, 0);
    CHECK(state.session.playback().range() == TimeRange{0, 2});
}

TEST_CASE("a choice of interpolation is an edit with undo, and the same choice is none") {
    ViewerState state(sample_family());
    choose_interpolation(state, {.basis = Basis::b_spline}, 0);
    CHECK(state.document.family().timeline->interpolation().basis == Basis::b_spline);
    CHECK(*state.document.undo_step() == "Interpolate by b-spline");
    choose_interpolation(state, {.basis = Basis::b_spline}, 0);
    undo(state, 0);
    CHECK(state.document.family().timeline->interpolation().basis == Basis::linear);
    CHECK(state.document.undo_step() == nullptr);

    ask_for_degree(state);
    CHECK_FALSE(fault(state, "0").empty());
    CHECK_FALSE(fault(state, "2.5").empty());
    answer(state, "2");
    CHECK(state.document.family().timeline->interpolation() ==
          Interpolation{.basis = Basis::bernstein, .degree = 2});
    for (std::size_t i = 0; i < bases().size(); ++i) cycle_interpolation(state, 0);
    CHECK(state.document.family().timeline->interpolation() == Interpolation{.basis = Basis::bernstein});
}

TEST_CASE("the selected key is put at the present time and taken off again") {
    ViewerState state(sample_family());
    state.selected_key = 1;
    state.session.seek(2.25, 0);
    CHECK_FALSE(has_present_time(state));
    add_present_time(state, 0);
    CHECK(has_present_time(state));
    CHECK(state.document.family().timeline->place_at(2.25));
    remove_present_time(state, 0);
    CHECK_FALSE(has_present_time(state));
}
