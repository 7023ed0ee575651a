// Tests of the panel of the parameter domain: dragging, at places that a float cannot hold.
#include "ui/panels/parameter_domain_panel.h"

#include <doctest/doctest.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "family/domain_edits.h"
#include "ui/headless_gui.h"
#include "ui/widgets/style.h"

using namespace interleaf;

namespace {

/// Corner of a square with side 2. Neighboring floats are 0.5 apart there.
constexpr glm::dvec2 low{6000000.3, -6000001.7};

/// More than a pixel, in units of the domain, because Dear ImGui uses whole pixels.
constexpr double a_pixel = 0.02;

Family distant_family() {
    Family family;
    family.name = "distant";
    for (const char* name : {"a", "b", "c", "d", "e"}) family.keys.push_back({name, {}});
    const glm::dvec2 right{2, 0};
    const glm::dvec2 up{0, 2};
    family.domain.emplace(
        std::vector<DomainVertex>{
            {low, 0}, {low + right, 1}, {low + right + up, 2}, {low + up, 3}, {low + 1.0, 4}},
        std::vector<Triangle>{{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}});
    return family;
}

/// The panel. Each frame gets the drag and the menu of the last result.
class Panel {
  public:
    Panel(Family family, bool edits) : family_(std::move(family)), edits_(edits) {}

    ParameterDomainResult show(glm::vec2 pointer, bool is_down) {
        gui_.begin_frame(pointer, is_down);
        begin_panel("right", {1000, 24, 280, 700});
        const std::optional<DomainPoint> point;
        ParameterDomainResult result = parameter_domain_panel(
            family_, {.point = point, .path = path, .edits = edits_, .drag = drag_, .menu = menu_});
        end_panel();
        gui_.end_frame();
        drag_ = result.drag;
        menu_ = result.menu;
        return result;
    }

    Family& family() { return family_; }

    bool has_color(ImU32 color, const Rect& area) const { return gui_.has_color(color, area); }

    std::vector<glm::dvec2> path;

  private:
    HeadlessGui gui_{{1280, 800}};
    Family family_;
    bool edits_;
    std::optional<DomainDrag> drag_;
    std::optional<DomainMenu> menu_;
};

/// The pixel of low + \p offset, if the plot shows the whole square.
glm::vec2 pixel(const Rect& plot, glm::dvec2 offset) {
    return {plot.x + plot.width * static_cast<float>(offset.x / 2),
            plot.bottom() - plot.height * static_cast<float>(offset.y / 2)};
}

}  // namespace

TEST_CASE("the path is a bright line with a dark rim, so that it is seen over any color") {
    Panel panel(distant_family(), false);
    panel.path = {low, low + glm::dvec2(2, 0)};
    for (int frame = 0; frame < 3; ++frame) panel.show({0, 0}, false);
    const Rect whole{1000, 24, 280, 700};
    CHECK(panel.has_color(colors::path_line, whole));
    CHECK(panel.has_color(colors::path_rim, whole));
}

TEST_CASE("a drag moves the point to the place under the pointer, however far the domain is from 0") {
    Panel panel(distant_family(), false);
    const Rect plot = panel.show({0, 0}, false).plot;
    panel.show(pixel(plot, {0.5, 0.5}), false);
    for (const glm::dvec2 offset : {glm::dvec2(0.5, 0.5), glm::dvec2(1.25, 0.75), glm::dvec2(1.5, 1.9)}) {
        CAPTURE(offset.x);
        const auto moved = panel.show(pixel(plot, offset), true).moved_to;
        REQUIRE(moved);
        CHECK(glm::distance(*moved - low, offset) < a_pixel);
    }
    CHECK_FALSE(panel.show(pixel(plot, {1, 1}), false).moved_to);
}

TEST_CASE("a drag moves a vertex to the place under the pointer, and the plane stays") {
    Panel panel(distant_family(), true);
    const Rect plot = panel.show({0, 0}, false).plot;
    panel.show(pixel(plot, {2, 2}), false);
    panel.show(pixel(plot, {2, 2}), true);
    for (const glm::dvec2 offset : {glm::dvec2(1.75, 1.5), glm::dvec2(1.75, 1.5), glm::dvec2(1.5, 1.75)}) {
        CAPTURE(offset.x);
        const ParameterDomainResult result = panel.show(pixel(plot, offset), true);
        REQUIRE(result.moved_vertex);
        CHECK(result.moved_vertex->vertex == 2);
        CHECK(glm::distance(result.moved_vertex->to - low, offset) < a_pixel);
        panel.family().domain = with_vertex_moved(*panel.family().domain, 2, result.moved_vertex->to);
    }
    // After the release, the plot shows the whole domain again.
    panel.show(pixel(plot, {1.5, 1.75}), false);
    const Rect after = panel.show({0, 0}, false).plot;
    CHECK(after.width == doctest::Approx(plot.width).epsilon(0.01));
}

TEST_CASE("a drag that began beside all vertices moves no vertex") {
    Panel panel(distant_family(), true);
    const Rect plot = panel.show({0, 0}, false).plot;
    panel.show(pixel(plot, {0.5, 1}), false);
    panel.show(pixel(plot, {0.5, 1}), true);
    CHECK_FALSE(panel.show(pixel(plot, {1, 1}), true).moved_vertex);
    CHECK_FALSE(panel.show(pixel(plot, {1.5, 1.5}), true).moved_vertex);
}
