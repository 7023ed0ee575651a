// Tests of strokes of the brush: each is one undoable step that changes the selected key alone.
#include "app/brushing/brush_stroke.h"

#include <memory>
#include <utility>
#include <vector>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "app/document/edit_commands.h"
#include "hierarchy/checker.h"
#include "hierarchy/marking.h"
#include "hierarchy/random_families.h"

using namespace interleaf;

namespace {

Hierarchy octahedron_key(float size) {
    std::vector<glm::vec3> positions = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    for (glm::vec3& position : positions) position *= size;
    return unrefined(mark_compatibly(testing::octahedron()), positions);
}

Family two_octahedra() {
    return {.name = "two",
            .keys = {{"small", octahedron_key(1)}, {"large", octahedron_key(2)}},
            .timeline = Timeline({{0, 0}, {1, 1}}),
            .domain = {}};
}

/// A viewer with the brush in hand, on the key "large".
ViewerState with_brush(Family family = two_octahedra()) {
    ViewerState state(std::move(family));
    state.selected_key = 1;
    toggle_brush(state, 0);
    return state;
}

const Ray from_above{{0.2F, 0.3F, 9}, {0.2F, 0.3F, -9}};
const Ray from_the_side{{9, 0.3F, 0.2F}, {-9, 0.3F, 0.2F}};
const Ray beside{{9, 9, 9}, {9, 9, -9}};

void stroke(BrushStroke& brush, ViewerState& state, bool coarsens = false) {
    brush.begin(state, coarsens);
    brush.touch(state, std::vector{from_above}, true, 0);
    brush.touch(state, std::vector{from_the_side}, false, 0);
    brush.end(state, 0);
}

}  // namespace

TEST_CASE(
    "the brush shows the selected key alone, at full detail, and takes levels around that of its leaves") {
    ViewerState state(two_octahedra());
    state.session.display.detail = 0.5F;
    state.selected_key = 1;
    CHECK(!brushed_key(state));
    toggle_brush(state, 0);
    CHECK(brushed_key(state) == 1);
    CHECK(state.session.weights() == Weights{{1, 1.0}});
    CHECK(state.session.display.detail == 1);
    CHECK(state.brush.refined_level == 2);
    CHECK(state.brush.coarsened_level == 0);
    state.session.seek(0.5, 0);
    CHECK(!brushed_key(state));
    toggle_brush(state, 0);
    CHECK(!state.brush.is_on);
}

TEST_CASE(
    "a field that raises flat keys stops the brush, also without its colors, and one of other keys does "
    "not") {
    for (const bool is_flat : {false, true}) {
        Family family = two_octahedra();
        Hierarchy key = is_flat ? unrefined(RootComplex(3, {{0, 1, 2}}), {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}})
                                : octahedron_key(1);
        Buffer<float> values(key.positions.size(), 1);
        values.front() = 0;
        key.fields = {{"heat", FieldKind::scalar, std::move(values)}};
        for (Key& each : family.keys) each.hierarchy = SharedHierarchy(Hierarchy(key));
        for (const bool is_colored : {false, true}) {
            ViewerState state = with_brush(family);
            state.session.display.height = 0.5F;
            if (is_colored) {
                state.session.display.coloring = Coloring::field;
                state.session.display.field = "heat";
            } else {
                state.session.display.raised_by = "heat";
            }
            CHECK(brushed_key(state).has_value() == !is_flat);
        }
    }
}

TEST_CASE("a stroke is one step of the selected key, and undo gives the identical hierarchy") {
    ViewerState state = with_brush();
    const std::shared_ptr<const Family> before = state.document.snapshot();
    BrushStroke brush;
    stroke(brush, state);
    const Family& after = state.document.family();
    REQUIRE(state.document.undo_step() != nullptr);
    CHECK(*state.document.undo_step() == "Refine large");
    CHECK(after.keys[0].hierarchy.is_same(before->keys[0].hierarchy));
    CHECK(after.keys[1].hierarchy->leaf_count() > 8);
    CHECK(check(*after.keys[1].hierarchy).empty());
    CHECK(check(after).empty());
    CHECK(brushed_key(state) == 1);
    CHECK(state.brush.report.starts_with("large: 8 to "));

    undo(state, 0);
    CHECK(state.document.undo_step() == nullptr);
    CHECK(state.document.family().keys[1].hierarchy.is_same(before->keys[1].hierarchy));
    CHECK(brushed_key(state) == 1);
    CHECK(state.brush.report.empty());
    redo(state, 0);
    CHECK(state.document.family().keys[1].hierarchy->leaf_count() > 8);
    CHECK(brushed_key(state) == 1);
}

TEST_CASE("a stroke shows in the document while it goes on, and all of it at its end") {
    ViewerState state = with_brush();
    BrushStroke brush;
    const auto leaves = [&] { return state.document.family().keys[1].hierarchy->leaf_count(); };
    brush.begin(state, false);
    brush.touch(state, std::vector{from_above}, false, 0);
    CHECK(leaves() == 8);
    brush.touch(state, {}, true, 0);
    const std::size_t shown = leaves();
    CHECK(shown > 8);
    brush.touch(state, std::vector{from_the_side}, false, 0);
    CHECK(leaves() == shown);
    brush.end(state, 0);
    CHECK(leaves() > shown);
    undo(state, 0);
    CHECK(leaves() == 8);
}

TEST_CASE("coarsening takes back what a stroke has refined") {
    ViewerState state = with_brush();
    state.brush.radius = max_brush_radius;
    BrushStroke brush;
    stroke(brush, state);
    stroke(brush, state, true);
    CHECK(state.document.family().keys[1].hierarchy->leaf_count() == 8);
    REQUIRE(state.document.undo_step() != nullptr);
    CHECK(*state.document.undo_step() == "Coarsen large");
}

TEST_CASE("a cancelled stroke leaves the document as it was") {
    ViewerState state = with_brush();
    const std::shared_ptr<const Family> before = state.document.snapshot();
    BrushStroke brush;
    brush.begin(state, false);
    brush.touch(state, std::vector{from_above}, true, 0);
    CHECK(state.document.is_changed());
    brush.cancel(state, 0);
    CHECK(!brush.is_active());
    CHECK(state.document.snapshot() == before);
    CHECK(!state.document.is_changed());
    CHECK(state.document.undo_step() == nullptr);
    CHECK(state.document.redo_step() == nullptr);
    CHECK(brushed_key(state) == 1);
}

TEST_CASE("a stroke without effect is no step") {
    ViewerState state = with_brush();
    BrushStroke brush;
    brush.begin(state, false);
    brush.touch(state, std::vector{beside}, true, 0);
    brush.end(state, 0);
    stroke(brush, state, true);
    CHECK(state.document.undo_step() == nullptr);
    CHECK(!state.document.is_changed());
    CHECK(state.brush.report.starts_with("Nothing to coarsen"));
}

TEST_CASE("an edit during a stroke ends the stroke") {
    ViewerState state = with_brush();
    BrushStroke brush;
    brush.begin(state, false);
    brush.touch(state, std::vector{from_above}, true, 0);
    undo(state, 0);
    const std::shared_ptr<const Family> undone = state.document.snapshot();
    brush.touch(state, std::vector{from_the_side}, true, 0);
    CHECK(!brush.is_active());
    brush.end(state, 0);
    CHECK(state.document.snapshot() == undone);
}

TEST_CASE("new vertices lie on the mesh that the key was fitted to, also in later strokes") {
    ViewerState state = with_brush();
    // The mesh is a ball around the key.
    BrushedKey ball(octahedron_key(2),
                    [](const glm::vec3& middle, float) { return 2.0F * glm::normalize(middle); });
    ball.refine({0, {0, 0, 0}, 9}, 8);
    const Hierarchy mesh = ball.freeze();
    FitComparison comparison;
    comparison.key = state.document.family().keys[1].hierarchy;
    comparison.positions.assign(mesh.positions.begin(), mesh.positions.end());
    for (const Leaf& leaf : leaves_of(mesh)) comparison.triangles.push_back(leaf.vertices);
    state.comparisons.push_back(std::make_shared<const FitComparison>(std::move(comparison)));

    BrushStroke brush;
    for (const int level : {2, 5}) {
        state.brush.refined_level = level;
        stroke(brush, state);
        const Hierarchy& key = *state.document.family().keys[1].hierarchy;
        CHECK(key.vertex_count() > 6);
        for (const glm::vec3& position : key.positions)
            CHECK(glm::length(position) == doctest::Approx(2).epsilon(0.03));
    }
}
