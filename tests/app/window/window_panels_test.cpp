// Tests of the panels together: an action in one panel shows in all panels in the same frame.
#include "app/window/window_panels.h"

#include <utility>

#include <doctest/doctest.h>

#include "app/sample_family.h"
#include "app/window/initial_state.h"
#include "app/window/window_actions.h"
#include "family/family_time.h"
#include "render/palette.h"
#include "ui/headless_gui.h"
#include "ui/widgets/command_keys.h"
#include "ui/widgets/gui_state.h"
#include "ui/widgets/style.h"

using namespace interleaf;

namespace {

constexpr glm::vec2 window{1280, 800};

/// The phases of the viewer's frame, without the surface.
class Panels {
  public:
    Panels() { gui_state()->command_keys = command_keys(table_shortcuts()); }

    ViewerState& state() { return state_; }

    /// Runs one frame.
    /// \return the window that the frame has drawn
    WindowResult frame(glm::vec2 pointer, bool is_down) {
        gui_.begin_frame(pointer, is_down);
        const WindowResult read = show();
        apply_to_state(read.actions, state_, holds_, now_ += 0.02);
        if (!is_down) state_.is_dragging = false;
        gui_.begin_drawing();
        WindowResult drawn = show();
        gui_.end_frame();
        return drawn;
    }

    /// The keys whose rows are marked as active.
    std::vector<std::size_t> marked_keys(const Rect& list) const {
        std::vector<std::size_t> marked;
        for (std::size_t key = 0; key < state_.document.family().keys.size(); ++key)
            if (gui_.has_color(to_color(key_color(key)), list)) marked.push_back(key);
        return marked;
    }

  private:
    WindowResult show() {
        portraits_.clear();
        for (const Key& key : state_.document.family().keys)
            portraits_.push_back({key.hierarchy, 1, 0, {}, {}});
        FrameLayout layout;
        layout.window = window;
        layout.content = {0, menu_bar_height(), window.x, window.y - menu_bar_height()};
        layout.panels = lay_out(window, menu_bar_height(), 1, state_.session.has_timeline());
        return show_window({.state = state_,
                            .recent_files = {},
                            .title = "sample",
                            .portraits = portraits_,
                            .fields = {},
                            .curves = {},
                            .figures = {},
                            .pictures = {},
                            .frame_milliseconds = 0,
                            .holds = holds_,
                            .layout = layout,
                            .comparison = nullptr});
    }

    HeadlessGui gui_{window};
    ViewerState state_{sample_family()};
    MouseHolds holds_;
    std::vector<KeyPortrait> portraits_;
    double now_ = 0;
};

glm::vec2 domain_pixel(const Rect& plot, glm::vec2 point) {
    return {plot.x + plot.width * (point.x + 1) / 2, plot.y + plot.height * (1 - point.y) / 2};
}

std::vector<std::size_t> sorted_active_keys(const ViewerState& state) {
    std::vector<std::size_t> keys = active_keys(state.session.weights());
    std::ranges::sort(keys);
    return keys;
}

}  // namespace

TEST_CASE("a drag in the domain marks the active keys in the frame that it moves the point in") {
    Panels panels;
    const Rect plot = *panels.frame({0, 0}, false).layout.domain;
    panels.frame(domain_pixel(plot, {0, -0.5}), false);
    panels.frame(domain_pixel(plot, {0, -0.5}), true);
    std::vector<std::size_t> before;
    for (const glm::vec2 point :
         {glm::vec2(0, -0.5), glm::vec2(0.5, 0.1), glm::vec2(-0.1, 0.6), glm::vec2(-0.7, 0)}) {
        CAPTURE(point.x);
        const WindowResult drawn = panels.frame(domain_pixel(plot, point), true);
        const std::vector<std::size_t> active = sorted_active_keys(panels.state());
        CHECK(active.size() == 3);
        CHECK(active != before);
        CHECK(panels.marked_keys(drawn.layout.keys) == active);
        CHECK(drawn.weights == panels.state().session.weights());
        before = active;
    }
}

TEST_CASE("a key that is chosen is marked alone in the same frame, and moves the point with it") {
    Panels panels;
    const WindowResult first = panels.frame({0, 0}, false);
    const glm::vec2 row{first.layout.keys.x + 100, first.layout.keys.y + 2.5F * first.layout.keys.height / 5};
    panels.frame(row, false);
    panels.frame(row, true);
    const WindowResult drawn = panels.frame(row, false);
    CHECK(panels.state().selected_key == 2);
    CHECK(panels.marked_keys(drawn.layout.keys) == std::vector<std::size_t>{2});
    REQUIRE(panels.state().session.point());
    CHECK(panels.state().session.point()->at == glm::dvec2(1, 1));
}

TEST_CASE("dragging a vertex of the domain is one step, however many frames it takes") {
    Panels panels;
    panels.state().edits_domain = true;
    const Rect plot = *panels.frame({0, 0}, false).layout.domain;
    panels.frame(domain_pixel(plot, {0, 0}), false);
    panels.frame(domain_pixel(plot, {0, 0}), true);
    for (const glm::vec2 point : {glm::vec2(0.2, 0.1), glm::vec2(0.3, 0.3), glm::vec2(0.5, 0.25)})
        panels.frame(domain_pixel(plot, point), true);
    panels.frame(domain_pixel(plot, {0.5, 0.25}), false);
    const glm::dvec2 at = panels.state().document.family().domain->vertices()[4].at;
    CHECK(at.x == doctest::Approx(0.5).epsilon(0.02));
    CHECK(at.y == doctest::Approx(0.25).epsilon(0.02));
    panels.state().document.undo();
    CHECK(panels.state().document.family().domain->vertices()[4].at == glm::dvec2(0, 0));
    CHECK(panels.state().document.undo_step() == nullptr);
}

TEST_CASE("showing the panels changes nothing") {
    Panels panels;
    panels.state().selected_key = 1;
    const auto family = panels.state().document.snapshot();
    for (int frame = 0; frame < 3; ++frame) panels.frame({640, 300}, false);
    CHECK(panels.state().document.snapshot() == family);
    CHECK(panels.state().session.weights() == Weights{{0, 1}, {1, 0}});
    CHECK(panels.state().selected_key == 1);
    CHECK(panels.state().session.display == Display());
}

TEST_CASE("the points of a path are dragged and inserted while the domain is edited, each as one step") {
    Panels panels;
    ViewerState& state = panels.state();
    state.document.edit("Add a path", [&] {
        Family family = state.document.family();
        family.path.emplace(std::vector<PathPoint>{{0, {-0.5, -0.5}}, {2, {0.5, -0.5}}});
        return with_time_source(std::move(family), TimeSource::path);
    }());
    state.session.replace_family(state.document.snapshot(), 0);
    state.edits_domain = true;
    const Rect plot = *panels.frame({0, 0}, false).layout.domain;
    const auto drag = [&](glm::vec2 from, glm::vec2 to) {
        panels.frame(domain_pixel(plot, from), false);
        panels.frame(domain_pixel(plot, from), true);
        panels.frame(domain_pixel(plot, (from + to) / 2.0F), true);
        panels.frame(domain_pixel(plot, to), true);
        panels.frame(domain_pixel(plot, to), false);
    };
    const auto points = [&] { return state.document.family().path->points(); };
    drag({0.5, -0.5}, {0.7, 0.2});
    CHECK(points()[1].at.x == doctest::Approx(0.7).epsilon(0.05));
    CHECK(points()[1].at.y == doctest::Approx(0.2).epsilon(0.1));
    CHECK(points()[1].time == 2);
    CHECK(state.selected_path_point == 1);
    CHECK(*state.document.undo_step() == "Move a path point");

    drag(glm::vec2(points()[0].at + points()[1].at) / 2.0F, {0.0, 0.6});
    REQUIRE(points().size() == 3);
    CHECK(points()[1].at.y == doctest::Approx(0.6).epsilon(0.05));
    CHECK(points()[1].time == doctest::Approx(1).epsilon(0.1));
    CHECK(*state.document.undo_step() == "Insert a path point");
    CHECK(state.document.family().domain == sample_family().domain);
    state.document.undo();
    state.document.undo();
    CHECK(points().size() == 2);
    CHECK(*state.document.undo_step() == "Add a path");
}

TEST_CASE("a click in the domain gives it the arrow keys, and a click elsewhere takes them away") {
    Panels panels;
    const Rect plot = *panels.frame({0, 0}, false).layout.domain;
    const auto click = [&](glm::vec2 at) {
        panels.frame(at, false);
        panels.frame(at, true);
        panels.frame(at, false);
    };
    click(domain_pixel(plot, {0.5, 0}));
    CHECK(panels.state().domain_has_focus);
    click({640, 300});
    CHECK_FALSE(panels.state().domain_has_focus);
}

TEST_CASE("tooltips name commands that there are, in every state of the panels") {
    Panels panels;
    panels.frame({0, 0}, false);
    panels.state().edits_domain = true;
    panels.state().shown_domain = DomainBox{{-0.5, -0.5}, {0.5, 0.5}};
    panels.state().help_shown = true;
    panels.state().key_search.is_shown = true;
    panels.frame({0, 0}, false);
    panels.state().edits_domain = false;
    panels.state().recording.emplace();
    panels.state().brush.is_on = true;
    panels.frame({0, 0}, false);
    CHECK(with_keys("Play it", {"Play"}) == "Play it (Space)");
}

TEST_CASE("a family without a domain is offered one where its panel would be") {
    Panels panels;
    ViewerState& state = panels.state();
    state.document.edit("Remove the domain", [&] {
        Family family = state.document.family();
        family.domain.reset();
        return family;
    }());
    state.session.replace_family(state.document.snapshot(), 0);
    const Rect right = panels.frame({0, 0}, false).layout.panels.right;
    const glm::vec2 button{right.x + right.width / 2, right.y + 42};
    panels.frame(button, false);
    panels.frame(button, true);
    panels.frame(button, false);
    REQUIRE(state.document.family().domain);
    CHECK(state.document.family().domain->vertices().size() == 5);
}
