#include "app/window/comparison_view.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>

#include <fmt/core.h>
#include <glm/geometric.hpp>

#include "app/window/camera_control.h"
#include "hierarchy/vertex_normals.h"
#include "render/pick.h"
#include "render/plain_mesh.h"
#include "text/shown_text.h"
#include "ui/panels/comparison_panel.h"
#include "ui/widgets/number_text.h"
#include "ui/widgets/style.h"
#include "ui/widgets/value_label.h"

namespace interleaf {

namespace {

constexpr const char* field_name = "distance";
constexpr float one[] = {1};

UnionField distance_field(Buffer<float> values) {
    UnionField field;
    field.label = {field_name, FieldKind::scalar};
    field.values.push_back(std::move(values));
    return field;
}

UnionMesh mesh_side(const FitComparison& comparison) {
    UnionMesh mesh = plain_mesh(comparison.triangles, comparison.positions);
    mesh.fields.push_back(
        distance_field({comparison.mesh_distances.begin(), comparison.mesh_distances.end()}));
    return mesh;
}

UnionMesh key_side(const FitComparison& comparison) {
    const std::array<const Hierarchy*, 1> key{&*comparison.key};
    UnionMesh mesh = unite(key);
    Buffer<float> values(mesh.vertex_count());
    for (std::size_t v = 0; v < values.size(); ++v)
        values[mesh.own_vertices.front()[v]] = comparison.key_distances[v];
    mesh.fields.push_back(distance_field(std::move(values)));
    return mesh;
}

/// The value of the only field of \p mesh at the first intersection with \p ray; none if they do not
/// intersect.
std::optional<float> value_at(const UnionMesh& mesh, const Ray& ray) {
    const auto hit = first_hit(mesh.triangles, mesh.positions.front(), ray);
    if (!hit) return std::nullopt;
    float value = 0;
    for (int corner = 0; corner < 3; ++corner)
        value += hit->barycentric[corner] *
                 mesh.fields.front()
                     .values.front()[mesh.triangles[hit->triangle][static_cast<std::size_t>(corner)]];
    return value;
}

/// The index of \p comparison in \p compared; 0 if it is not there.
std::size_t index_of(const std::vector<ComparedKey>& compared,
                     const std::shared_ptr<const FitComparison>& comparison) {
    const auto found = std::ranges::find(compared, comparison, &ComparedKey::comparison);
    return found == compared.end() ? 0 : static_cast<std::size_t>(found - compared.begin());
}

ComparisonShown shown_of(const ViewerState& state, const std::vector<ComparedKey>& compared,
                         std::size_t chosen, const ColorScale& scale) {
    const FitQuality& quality = compared[chosen].comparison->quality;
    ComparisonShown shown{.names = {},
                          .chosen = chosen,
                          .hausdorff = 100 * quality.hausdorff,
                          .root_mean_square = 100 * quality.root_mean_square,
                          .min_angle = quality.min_angle,
                          .flipped_leaves = quality.flipped_leaves,
                          .has_colors = state.compares_colors,
                          .scale = scale};
    for (const ComparedKey& each : compared)
        shown.names.push_back(state.document.family().keys[each.key].name);
    return shown;
}

}  // namespace

void ComparisonView::take(std::shared_ptr<const FitComparison> taken, std::string_view key_name,
                          const Camera& from) {
    const FitComparison& comparison = *taken;
    if (!sides_) sides_.emplace();
    auto& [mesh, key] = *sides_;
    mesh.mesh = mesh_side(comparison);
    mesh.title = fmt::format("{}   {} triangles", shown_name(comparison.mesh_name),
                             grouped(comparison.triangles.size()));
    key.mesh = key_side(comparison);
    key.title = fmt::format("{}   {} leaves", key_name, grouped(comparison.key->leaf_count()));
    for (Side& side : *sides_) {
        side.renderer.upload(side.mesh, normal_form(side.mesh));
        side.renderer.set_field(&side.mesh.fields.front());
    }
    scale_ = {.map = ColorMap::viridis, .range = {0, max_distance(comparison)}};
    extent_ =
        extent_of(std::array<std::span<const glm::vec3>, 2>{comparison.positions, comparison.key->positions});
    camera_ = from;
    view_all_wanted_ = true;
    shown_ = std::move(taken);
    ++surface_;
}

void ComparisonView::follow(ViewerState& state, const Rect& area, const Camera& from) {
    is_shown_ = false;
    if (!state.is_comparing) return;
    const auto compared = compared_keys(state.document.family(), state.comparisons);
    if (compared.empty()) return;
    const std::size_t chosen = index_of(compared, state.compared);
    if (compared[chosen].comparison != shown_)
        take(compared[chosen].comparison, state.document.family().keys[compared[chosen].key].name,
             shown_ ? camera_ : from);
    place(area);
    has_colors_ = state.compares_colors;
    if (std::exchange(state.view_target, ViewTarget::none) != ViewTarget::none) view_all_wanted_ = true;
    if (std::exchange(view_all_wanted_, false)) camera_.view_all(extent_, aspect_of((*sides_)[0].view));
    is_shown_ = true;
}

void ComparisonView::place(const Rect& area) {
    const float panel = std::min(comparison_panel_height(area.width), area.height / 2);
    const float half = std::round(area.width / 2);
    const float height = area.height - panel;
    (*sides_)[0].view = {area.x, area.y, half, height};
    (*sides_)[1].view = {area.x + half, area.y, area.width - half, height};
    panel_ = {area.x, area.y + height, area.width, panel};
}

ComparisonActions ComparisonView::show(const ViewerState& state, bool has_keyboard) const {
    const auto& [mesh, key] = *sides_;
    const std::array<ViewInput, 2> inputs{view_area(mesh.view, "mesh"), view_area(key.view, "key")};
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    for (const Side& side : *sides_)
        list.AddText({side.view.x + scaled(12), side.view.y + scaled(9)}, colors::text, side.title.c_str());
    list.AddLine({key.view.x, key.view.y}, {key.view.x, key.view.bottom()}, colors::dark);
    const auto compared = compared_keys(state.document.family(), state.comparisons);
    return {inputs, comparison_panel(panel_, shown_of(state, compared, index_of(compared, shown_), scale_),
                                     has_keyboard)};
}

void ComparisonView::apply_to_comparison(const ComparisonActions& actions, ViewerState& state) {
    pointer_.reset();
    for (std::size_t side = 0; side < sides_->size(); ++side) {
        const ViewInput& input = actions.sides[side];
        move_camera(camera_, input, state.camera.orbit, (*sides_)[side].view,
                    (*sides_)[side].picture.target());
        if (input.view_all) view_all_wanted_ = true;
        if (!input.pointed_at) continue;
        pointer_ = input.pointer;
        pointed_at_ = side;
    }
    const auto compared = compared_keys(state.document.family(), state.comparisons);
    state.compared = compared[actions.panel.chosen].comparison;
    state.compares_colors = actions.panel.has_colors;
    if (actions.panel.is_over) state.is_comparing = false;
}

bool ComparisonView::draw(const Display& display, const Gui& gui, float window_height) {
    const auto pixels = [&](float length) { return static_cast<int>(std::lround(length * gui.density())); };
    bool is_good = true;
    for (Side& side : *sides_) {
        Scene scene{.width = std::max(pixels(side.view.width), 1),
                    .height = std::max(pixels(side.view.height), 1),
                    .camera = camera_,
                    .weights = {one[0]},
                    .display = display,
                    .surface = surface_,
                    .box = {},
                    .view = 0};
        scene.display.detail = 1;
        scene.display.ground = false;
        scene.display.shading = display.shading.value_or(usual_shading(side.mesh.triangles.size()));
        scene.display.follows_camera = false;
        scene.display.line_width *= gui.scale() * gui.density();
        scene.display.coloring = has_colors_ ? Coloring::field : Coloring::plain;
        scene.display.field = field_name;
        scene.display.scale = scale_;
        is_good &= side.picture.update(side.renderer, scene);
        side.picture.target()->blit_to_window(pixels(side.view.x),
                                              pixels(window_height - side.view.bottom()));
    }
    return is_good;
}

void ComparisonView::show_value() const {
    if (!pointer_ || !has_colors_) return;
    const Side& side = (*sides_)[pointed_at_];
    const glm::vec2 at = device_coordinates(side.view, *pointer_);
    const float aspect = aspect_of(side.view);
    const auto value =
        value_at(side.mesh, {camera_.point_at(at, 0, aspect), camera_.point_at(at, 1, aspect)});
    if (value) value_label(*pointer_, side.view, scale_.color(*value), fmt::format("{:.3g} %", *value));
}

void ComparisonView::reload_shaders() {
    if (!sides_) return;
    for (Side& side : *sides_) {
        side.renderer.reload_shaders();
        side.picture.reload_shaders();
    }
}

}  // namespace interleaf
