// Tests of the Blend menu: what drives, and weights set by hand.
#include "app/document/blend_commands.h"

#include <doctest/doctest.h>

#include "app/document/edit_commands.h"
#include "app/sample_family.h"
#include "hierarchy/morph.h"

using namespace interleaf;

TEST_CASE("each driver takes over, and the others come back to where they were") {
    ViewerState state(sample_family());
    state.session.seek(2, 0);
    const Weights by_time = state.session.weights();
    state.session.move_point({0.5, 0.25}, 0);
    const Weights by_point = state.session.weights();

    choose_driver(state, Driver::weights, 1);
    CHECK(state.session.driver() == Driver::weights);
    CHECK(state.session.weights() == by_point);
    state.session.set_weights({{1, 0.25}, {3, 2}}, 2);
    CHECK(state.session.weights() == Weights{{1, 0.25}, {3, 2}});
    CHECK_FALSE(state.session.point());

    choose_driver(state, Driver::point, 3);
    CHECK(state.session.weights() == by_point);
    choose_driver(state, Driver::timeline, 4);
    CHECK(state.session.weights() == by_time);
    CHECK_FALSE(state.session.is_playing());
    state.selected_key = 4;
    choose_driver(state, Driver::key, 5);
    CHECK(state.session.weights() == Weights{{4, 1}});
}

TEST_CASE("turning parts is a step that is undone") {
    ViewerState state(sample_family());
    CHECK_FALSE(is_turning(state));
    toggle_turning(state, 0);
    CHECK(state.document.family().blend == BlendKind::turning);
    CHECK(is_turning(state));
    choose_blend(state, BlendKind::turning, 0);  // no step
    undo(state, 0);
    CHECK_FALSE(is_turning(state));
    redo(state, 0);
    toggle_turning(state, 0);
    CHECK_FALSE(is_turning(state));
}

TEST_CASE("a blend that turns is kept as it is shown") {
    ViewerState state(sample_family());
    toggle_turning(state, 0);
    state.session.set_weights({{0, 0.5}, {1, 0.5}}, 0);
    UnionMesh mesh = unite(state.document.family(), state.session.weights());
    set_blend(mesh, BlendKind::turning);
    keep_blend(state, 0);
    const Hierarchy& kept = *state.document.family().keys.back().hierarchy;
    CHECK(kept.positions == morphed_hierarchy(mesh, std::vector{0.5F, 0.5F}).positions);
}

TEST_CASE("without a selected key, the key with the largest weight is shown alone") {
    ViewerState state(sample_family());
    state.session.set_weights({{1, 0.25}, {3, 0.5}, {4, 0.25}}, 0);
    choose_driver(state, Driver::key, 1);
    CHECK(state.selected_key == 3u);
    CHECK(state.session.weights() == Weights{{3, 1}});
}

TEST_CASE("a driver that the family lacks is not chosen") {
    Family family = sample_family();
    family.timeline.reset();
    family.domain.reset();
    ViewerState state(std::move(family));
    choose_driver(state, Driver::timeline, 0);
    choose_driver(state, Driver::point, 0);
    CHECK(state.session.driver() == Driver::key);
}

TEST_CASE("weights set by hand stop playback, and time does not change them") {
    ViewerState state(sample_family());
    state.session.toggle_playing(0);
    state.session.set_weights({{0, 3}}, 1);
    CHECK_FALSE(state.session.is_playing());
    CHECK(state.session.time() == doctest::Approx(1));
    state.session.advance(7);
    CHECK(state.session.weights() == Weights{{0, 3}});
    state.session.toggle_playing(8);
    CHECK(state.session.driver() == Driver::timeline);
}

TEST_CASE("weights that are those of a point show the point") {
    ViewerState state(sample_family());
    state.session.move_point({0.5, 0.25}, 0);
    const Weights weights = state.session.weights();
    state.session.seek(0, 0);
    state.session.set_weights(weights, 0);
    REQUIRE(state.session.point());
    CHECK(state.session.point()->at.x == doctest::Approx(0.5));
}

TEST_CASE("the sum becomes 1, and reset returns to the weights before the first slider") {
    ViewerState state(sample_family());
    state.session.seek(0.25, 0);
    const Weights first = state.session.weights();
    CHECK_FALSE(can_reset_weights(state));
    state.session.set_weights({{0, 1}, {1, 3}}, 0);
    state.session.set_weights({{0, 2}, {1, 6}}, 0);
    CHECK(can_make_weights_sum_to_one(state));
    make_weights_sum_to_one(state, 0);
    CHECK(state.session.weights() == Weights{{0, 0.25}, {1, 0.75}});
    CHECK_FALSE(can_make_weights_sum_to_one(state));
    CHECK(can_reset_weights(state));
    reset_weights(state, 0);
    CHECK(state.session.weights() == first);
    CHECK(state.session.driver() == Driver::weights);
    CHECK_FALSE(can_reset_weights(state));
}

TEST_CASE("weights by hand follow their keys through edits, and a blend of them becomes a key") {
    ViewerState state(sample_family());
    state.session.set_weights({{1, 0.25}, {3, 2}}, 0);
    keep_blend(state, 0);
    CHECK(state.document.family().keys.size() == 6);
    CHECK(state.session.weights() == Weights{{1, 0.25}, {3, 2}});
    state.selected_key = 0;
    remove_key(state, 0);
    CHECK(state.session.weights() == Weights{{0, 0.25}, {2, 2}});
    state.selected_key = 0;
    remove_key(state, 0);
    CHECK(state.session.weights() == Weights{{1, 2}});
    CHECK(state.session.driver() == Driver::weights);
    state.selected_key = 1;
    remove_key(state, 0);
    CHECK(state.session.driver() != Driver::weights);
    undo(state, 0);
    undo(state, 0);
    CHECK_FALSE(state.session.weights().empty());
}
