#include "app/window/key_views.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <fmt/core.h>
#include <imgui.h>

#include "app/pictures/morph_surface.h"
#include "app/window/camera_control.h"
#include "hierarchy/vertex_normals.h"
#include "render/palette.h"
#include "render/surface_values.h"
#include "ui/widgets/outline_marks.h"
#include "ui/widgets/style.h"
#include "ui/widgets/swatch.h"

namespace interleaf {
namespace {

/// Time for new pictures per frame, milliseconds; at least one is drawn.
constexpr double draw_budget = 25;

constexpr std::array<float, 1> whole_weight{1};

}  // namespace

void KeyViews::follow(const Session& session, std::span<const Rect> places, const FamilyField* field) {
    const Family& family = session.family();
    const std::size_t count = std::min(places.size(), session.weights().size());
    const Coloring coloring = session.display.coloring;
    const bool has_values = coloring == Coloring::angle || coloring == Coloring::curvature;
    const Values values{has_values ? coloring : Coloring::plain,
                        field != nullptr ? std::optional(field->label) : std::nullopt};
    std::vector<std::unique_ptr<View>> views;
    views.reserve(count);
    for (std::size_t n = 0; n < count; ++n) {
        const std::size_t key = session.weights()[n].key;
        const SharedHierarchy& hierarchy = family.keys[key].hierarchy;
        const auto known = std::ranges::find_if(
            views_, [&](const auto& view) { return view && view->hierarchy.is_same(hierarchy); });
        views.push_back(known != views_.end() ? std::move(*known) : std::make_unique<View>());
        View& view = *views.back();
        if (!view.hierarchy.is_same(hierarchy) || view.key != key || view.values != values) {
            view.hierarchy = hierarchy;
            view.key = key;
            take_key(view, family, values);
        }
        view.name = family.keys[key].name;
        view.place = places[n];
    }
    views_ = std::move(views);
    more_ = session.weights().size() - count;
}

void KeyViews::take_key(View& view, const Family& family, const Values& values) {
    const std::array<const Hierarchy*, 1> hierarchy{&*view.hierarchy};
    const std::array<std::size_t, 1> key{view.key};
    view.mesh = unite(hierarchy);
    view.renderer.upload(view.mesh, normal_form(view.mesh), key);
    const Weights alone{{view.key, 1.0}};
    if (values.field && !key_without(family, alone, *values.field)) {
        const UnionField united = united_field(family, alone, view.mesh, *values.field);
        view.renderer.set_field(&united);
    } else if (values.coloring != Coloring::plain) {
        view.renderer.set_values(surface_values(values.coloring, view.mesh, view.mesh.positions.front()));
    }
    view.values = values;
    view.number = ++number_;
}

std::optional<NodePath> KeyViews::leaf_at(std::size_t place, glm::vec2 pointer, const Camera& camera) const {
    if (place >= views_.size()) return std::nullopt;
    const View& view = *views_[place];
    const glm::vec2 at = device_coordinates(view.place, pointer);
    const float aspect = aspect_of(view.place);
    return leaf_where_hit(view.mesh, view.mesh.positions.front(),
                          {camera.point_at(at, 0, aspect), camera.point_at(at, 1, aspect)});
}

bool KeyViews::draw(const Display& display, const ColorScale& scale, const Camera& camera, const Gui& gui,
                    float window_height) {
    const auto pixels = [&](float length) { return static_cast<int>(std::lround(length * gui.density())); };
    bool is_good = true;
    double spent = 0;
    const std::size_t first = views_.empty() ? 0 : next_ % views_.size();
    for (std::size_t n = 0; n < views_.size(); ++n) {
        const std::size_t place = (first + n) % views_.size();
        View& view = *views_[place];
        Scene scene{.width = std::max(pixels(view.place.width), 1),
                    .height = std::max(pixels(view.place.height), 1),
                    .camera = camera,
                    .weights = {whole_weight[0]},
                    .display = display,
                    .surface = view.number,
                    .box = {},
                    .view = 0};
        scene.display.ground = false;
        scene.display.shading = display.shading.value_or(usual_shading(view.hierarchy->leaf_count()));
        scene.display.detail = 1;
        scene.display.follows_camera = false;
        if (is_measured(display.coloring)) scene.display.scale = scale;
        scene.display.line_width *= gui.scale() * gui.density();
        if (spent < draw_budget || view.picture.target() == nullptr) {
            const std::size_t before = view.picture.drawings();
            is_good &= view.picture.update(view.renderer, scene);
            if (view.picture.drawings() != before) spent += view.picture.milliseconds();
            next_ = place + 1;
        } else {
            is_good = false;
        }
        view.picture.target()->blit_to_window(pixels(view.place.x),
                                              pixels(window_height - view.place.bottom()));
    }
    return is_good;
}

void KeyViews::draw_marks(const Camera& camera, const std::optional<NodePath>& node, const Gui& gui) {
    ImGui::PushFont(small_font());
    for (const auto& view : views_) draw_name(*view);
    if (more_ > 0 && !views_.empty()) {
        const Rect& last = views_.back()->place;
        ImGui::GetBackgroundDrawList()->AddText(
            {last.x + scaled(8), last.bottom() - ImGui::GetTextLineHeight() - scaled(6)}, colors::text,
            fmt::format("and {} more", more_).c_str());
    }
    ImGui::PopFont();
    if (!node) return;
    for (const auto& view : views_)
        if (view->picture.target() != nullptr && node->root < view->mesh.roots.triangle_count())
            draw_outline(*view, camera, *node, gui);
}

void KeyViews::draw_name(const View& view) {
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    const Rect& place = view.place;
    list.AddLine({place.x, place.y}, {place.x, place.bottom()}, colors::dark);
    list.AddLine({place.x, place.y}, {place.right(), place.y}, colors::dark);
    const glm::vec2 corner(place.x + scaled(8), place.y + scaled(6));
    draw_swatch(list, corner, ImGui::GetTextLineHeight(), key_color(view.key));
    list.PushClipRect({place.x, place.y}, {place.right() - scaled(6), place.bottom()}, true);
    list.AddText({corner.x + swatch_side() + scaled(6), corner.y}, colors::text, view.name.c_str());
    list.PopClipRect();
}

void KeyViews::draw_outline(View& view, const Camera& camera, const NodePath& node, const Gui& gui) {
    view.outline.follow(view.mesh, {false, view.number}, node);
    OffscreenTarget& target = *view.picture.target();
    const std::vector<float> depths = target.read_depths();
    const Outline outline =
        view.outline.outline([&](Index vertex) { return view.mesh.positions.front()[vertex]; }, camera,
                             {target.width(), target.height(), depths});
    outline_mark(in_window(outline, {view.place.x, view.place.y}, gui.density()), view.place, false);
}

void KeyViews::reload_shaders() {
    for (const auto& view : views_) {
        view->renderer.reload_shaders();
        view->picture.reload_shaders();
    }
}

}  // namespace interleaf
