#include "app/window/surface_view.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include <fmt/core.h>
#include <glm/common.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>

#include "app/document/shown_field.h"
#include "app/document/shown_shading.h"
#include "app/window/camera_control.h"
#include "hierarchy/color.h"
#include "hierarchy/morph.h"
#include "render/pick.h"
#include "render/surface_values.h"
#include "ui/widgets/arrow_marks.h"
#include "ui/widgets/value_label.h"

namespace interleaf {

namespace {

/// A whole surface that takes longer to draw, milliseconds, is not drawn while it moves.
constexpr double slow_whole_from = 40;

/// Fewer leaves are drawn whole in any case: fewer would not be much faster.
constexpr std::size_t min_slow_leaves = 100'000;

/// Interval after which a surface that does not move is at rest, seconds.
constexpr double rest_from = 0.4;

/// Keys that are measured at a time: active ones, and some that will be active soon.
constexpr std::size_t max_measured = 8;

/// Leaves of all active keys together, at least those of their union.
std::size_t leaves_of(const Family& family, const Weights& weights) {
    std::size_t leaves = 0;
    for (const Weight& weight : weights) leaves += family.keys[weight.key].hierarchy->leaf_count();
    return leaves;
}

/// Side of a cell with at most one arrow, at scale 1.
constexpr float arrow_cell = 24;

/// The camera's first direction, in degrees.
constexpr glm::vec2 usual_direction{30, 20};

/// The extent of both.
Extent together(const Extent& a, const Extent& b) {
    const Box box{glm::min(a.box.min, b.box.min), glm::max(a.box.max, b.box.max)};
    return box.min == a.box.min && box.max == a.box.max ? a : extent_of(box);
}

float size_of(const Box& box) {
    const glm::vec3 size = box.max - box.min;
    return std::max({size.x, size.y, size.z});
}

}  // namespace

SurfaceView::SurfaceView() {
    camera_.look_from(usual_direction.x, usual_direction.y);
}

void SurfaceView::set_extent(const Extent& all_keys) {
    all_keys_ = all_keys;
    camera_.keep_unclipped(all_keys);
    const std::optional<unsigned> axis = flat_axis(all_keys.box);
    if (axis == axis_) return;
    axis_ = axis;
    if (axis_)
        face_plane();
    else
        camera_.look_from(usual_direction.x, usual_direction.y);
}

/// Looks at the plane of the keys from its front, or at their heights from the side to which they rise.
void SurfaceView::face_plane() {
    glm::vec3 raised(0);
    raised[static_cast<int>(*axis_)] = 1;
    camera_.look_from_end(warped_.is_warped() ? raised : front_of_plane(*axis_, camera_.up()));
    if (!warped_.is_warped()) return;
    const auto [azimuth, elevation, roll] = camera_.direction();
    if (elevation < 45)
        camera_.look_from(azimuth - 30, 25);
    else
        camera_.look_from(usual_direction.x, 35);
}

void SurfaceView::set_up(UpAxis up) {
    if (up == camera_.up()) return;
    camera_.set_up(up);
    if (axis_) face_plane();
}

void SurfaceView::apply_to_camera(const ViewInput& input, OrbitStyle style, const Rect& view) {
    ViewInput applied = input;
    if (axis_ && !warped_.is_warped() && !input.turns_flat) applied.pan += std::exchange(applied.orbit, {});
    move_camera(camera_, applied, style, view, picture_.target());
}

void SurfaceView::follow(const Session& session, const FamilyField* field,
                         std::span<const FamilyField> fields, double now) {
    if (camera_ != last_camera_ || session.weights() != last_weights_) moved_at_ = now;
    last_weights_ = session.weights();
    last_camera_ = camera_;
    want_details(session);
    const bool showed_view = shows_view_;
    const bool can_follow = !needs_whole(session, fields);
    holds_view_ = false;
    shows_view_ = can_follow && wants_view(session, now) &&
                  detail_surface_.follow(session.family(), session.weights(), details_);
    if (shows_view_) return;
    waits_ = false;
    if (showed_view && can_follow && session.display.detail >= 1 &&
        surface_.prepares(session.family(), session.weights())) {
        holds_view_ = shows_view_ = waits_ = true;
        return;
    }
    if (showed_view) picture_.forget();  // so that the whole surface is drawn in its final quality at once
    follow_whole(session, field, fields);
}

/// Updates the surface whose detail does not follow the camera.
void SurfaceView::follow_whole(const Session& session, const FamilyField* field,
                               std::span<const FamilyField> fields) {
    const bool was_warped = warped_.is_warped();
    detailed_.follow(session.family(), session.weights(), session.display.detail, details_);
    warped_.follow(detailed_.family(), detailed_.weights(), detailed_.sources(),
                   warp_of(session.display, fields, all_keys_.box));
    if (axis_ && was_warped != warped_.is_warped()) {
        face_plane();
        must_frame_ = true;
    }
    surface_.update(warped_.family(), warped_.weights(), field != nullptr ? &field->label : nullptr,
                    warped_.sources());
    // A late surface has other keys than the weights.
    arrows_.follow(warped_.family(), warped_.weights(), surface_.mesh(), surface_.figures().rebuilds,
                   surface_.figures().is_late ? std::nullopt : shown_vector(session.display, fields));
    if (session.display.detail >= 1 && !warped_.is_warped())
        surface_.expect(session.family(), session.next_key_sets());
    if (warped_.is_warped()) camera_.keep_unclipped(raised_extent());
}

/// Lets the details be measured that the display asks for, or that moving a slow surface takes: first those of
/// the active keys, then those of keys that will be active soon.
void SurfaceView::want_details(const Session& session) {
    const std::size_t leaves = leaves_of(session.family(), session.weights());
    const bool is_large = is_slow_ && leaves > min_slow_leaves;
    KeyDetails::Keys keys;
    if (session.display.detail < 1 || session.display.follows_camera || is_large) {
        const auto add = [&](std::size_t key) {
            const SharedHierarchy& hierarchy = session.family().keys[key].hierarchy;
            if (std::ranges::none_of(keys, [&](const auto& each) { return each.is_same(hierarchy); }))
                keys.push_back(hierarchy);
        };
        for (const Weight& weight : session.weights()) add(weight.key);
        for (const std::vector<std::size_t>& set : session.next_key_sets())
            for (const std::size_t key : set)
                if (keys.size() < max_measured) add(key);
    }
    details_.want(std::move(keys));
}

/// Whether only the whole surface will do: for heights, for arrows, and for parts that turn.
bool SurfaceView::needs_whole(const Session& session, std::span<const FamilyField> fields) const {
    const Display& display = session.display;
    return turns(session.family().blend, session.weights().size()) || warped_.is_warped() ||
           warp_of(display, fields, all_keys_.box) || shown_vector(display, fields);
}

/// Whether the detail of the surface follows the camera: because the display says so, or while a large surface
/// moves on a slow machine.
bool SurfaceView::wants_view(const Session& session, double now) {
    const Display& display = session.display;
    const std::size_t leaves = leaves_of(session.family(), session.weights());
    const std::size_t roots = session.family().keys.front().hierarchy->roots.triangle_count();
    if (leaves <= view_leaf_budget || roots > view_leaf_budget) return false;
    if (display.follows_camera) {
        waits_ = false;
        return true;
    }
    if (display.detail < 1 || !is_slow_ || leaves <= min_slow_leaves) return false;
    waits_ = now - moved_at_ < rest_from || surface_.prepares(session.family(), session.weights());
    return waits_;
}

/// The extent of all keys, with room for the largest height.
Extent SurfaceView::raised_extent() const {
    Box box = all_keys_.box;
    box.max[static_cast<int>(*axis_)] += size_of(box);
    return extent_of(box);
}

/// The extent of all keys, at the height at which they are shown.
Extent SurfaceView::scene() const {
    return warped_.is_warped() ? raised_extent() : all_keys_;
}

void SurfaceView::aim(ViewTarget view_target, const Rect& view) {
    if (std::exchange(must_frame_, false) && view_target == ViewTarget::none)
        view_target = ViewTarget::all_keys;
    if (view_target == ViewTarget::surface || (view_target != ViewTarget::none && warped_.is_warped())) {
        const Extent shown =
            shows_view_ && detail_surface_.version() > 0 ? detail_surface_.extent() : surface_.extent();
        camera_.keep_unclipped(together(scene(), shown));
        camera_.frame(shown, aspect_of(view));
    } else if (view_target == ViewTarget::all_keys)
        camera_.view_all(all_keys_, aspect_of(view));
    last_camera_ = camera_;
}

void SurfaceView::look(const Viewpoint& viewpoint, const Rect& view) {
    camera_ = camera_at(scene(), viewpoint, aspect_of(view));
    last_camera_ = camera_;
}

void SurfaceView::refine(const Session& session, const FamilyField* field, const Rect& view) {
    if (!shows_view_) follow_measured(session);
    if (!shows_view_ || holds_view_) return;
    detail_surface_.refine(session.family(), session.weights(), camera_, aspect_of(view),
                           field != nullptr ? &field->label : nullptr);
    view_figures_ = detail_surface_.figures();
    view_figures_.rebuilds = surface_.figures().rebuilds;
    view_figures_.waits = surface_.figures().waits;
    follow_measured(session);
}

/// Gives the shown surface the values of a coloring by values that the blend determines.
void SurfaceView::follow_measured(const Session& session) {
    const Coloring coloring = session.display.coloring;
    if (!is_measured(coloring)) return measured_.forget();
    measured_.keep_range(session.display.kept_range());
    const MeasuredColoring::Subject subject{
        .coloring = coloring,
        .mesh = {shows_view_, shows_view_ ? detail_surface_.version() : surface_.figures().rebuilds},
        .weights = shows_view_ ? std::vector<float>{} : surface_.weights(),
        .keys = figures().keys};
    if (measured_.has(subject)) return;
    measured_.take(subject, shows_view_ ? detail_surface_.mesh() : surface_.mesh(), blend_positions(),
                   shows_view_ ? detail_surface_.renderer() : surface_.renderer());
    picture_.forget();
}

/// Of the shown surface.
Buffer<glm::vec3> SurfaceView::blend_positions() const {
    if (!shows_view_) return morph(surface_.mesh(), surface_.weights());
    const auto positions = detail_surface_.positions();
    return {positions.begin(), positions.end()};
}

bool SurfaceView::draw(const Session& session, const Rect& view, const Gui& gui, float window_height) {
    const auto pixels = [&](float length) { return static_cast<int>(std::lround(length * gui.density())); };
    Box box = all_keys_.box;
    if (warped_.is_warped()) box.max[static_cast<int>(*axis_)] += session.display.height * size_of(box);
    Scene scene{.width = std::max(pixels(view.width), 1),
                .height = std::max(pixels(view.height), 1),
                .camera = camera_,
                .weights = shows_view_ ? std::vector{1.0F} : surface_.weights(),
                .display = session.display,
                .surface = surface_.figures().rebuilds,
                .box = box,
                .view = shows_view_ ? detail_surface_.version() : 0};
    // What the renderer is given has its detail already.
    scene.display.detail = 1;
    scene.display.follows_camera = false;
    scene.display.shading = shown_shading(session);
    if (is_measured(scene.display.coloring)) scene.display.scale = measured_.scale();
    scene.display.line_width *= gui.scale() * gui.density();
    const bool is_good =
        picture_.update(shows_view_ ? detail_surface_.renderer() : surface_.renderer(), scene);
    if (!shows_view_ && session.display.detail >= 1) is_slow_ = picture_.milliseconds() > slow_whole_from;
    picture_.target()->blit_to_window(pixels(view.x), pixels(window_height - view.bottom()));
    return is_good && (shows_view_ || !surface_.figures().is_late);
}

void SurfaceView::draw_arrows(const Rect& view, const Gui& gui) {
    if (shows_view_ || !arrows_.are_shown()) return;
    const OffscreenTarget& target = *picture_.target();
    for (const Arrow& arrow : arrows_.arrows(surface_.mesh(), warped_.weights(), camera_,
                                             {target.width(), target.height(), depths()},
                                             arrow_cell * gui.scale() * gui.density()))
        arrow_mark(glm::vec2(view.x, view.y) + arrow.from / gui.density(),
                   glm::vec2(view.x, view.y) + arrow.to / gui.density());
}

void SurfaceView::draw_outline(const NodePath& node, bool has_numbers, const Rect& view, const Gui& gui) {
    const UnionMesh& mesh = shows_view_ ? detail_surface_.mesh() : surface_.mesh();
    if (node.root >= mesh.roots.triangle_count()) return;
    outline_.follow(
        mesh, {shows_view_, shows_view_ ? detail_surface_.version() : surface_.figures().rebuilds}, node);
    const Buffer<glm::vec3> turned = mesh.turning ? blend_positions() : Buffer<glm::vec3>{};
    const auto position = [&](Index vertex) {
        if (shows_view_) return detail_surface_.positions()[vertex];
        if (mesh.turning) return turned[vertex];
        glm::vec3 sum(0);
        for (std::size_t key = 0; key < mesh.key_count(); ++key)
            sum += surface_.weights()[key] * mesh.positions[key][vertex];
        return sum;
    };
    const OffscreenTarget& target = *picture_.target();
    const Outline outline = outline_.outline(position, camera_, {target.width(), target.height(), depths()});
    outline_mark(in_window(outline, {view.x, view.y}, gui.density()), view, has_numbers);
}

bool SurfaceView::shows_turning() const {
    return !shows_view_ && !warped_.is_warped() && (surface_.figures().is_late || surface_.mesh().turning);
}

std::optional<std::array<glm::vec3, 3>> SurfaceView::turned_corners(const NodePath& node) {
    if (surface_.figures().is_late) return std::nullopt;
    outline_.follow(surface_.mesh(), {false, surface_.figures().rebuilds}, node);
    const Buffer<glm::vec3> positions = blend_positions();
    return outline_.corners([&](Index vertex) { return positions[vertex]; });
}

/// The depths of the picture, read once per drawing.
const std::vector<float>& SurfaceView::depths() {
    if (depths_of_ != picture_.drawings() || depths_.empty()) depths_ = picture_.target()->read_depths();
    depths_of_ = picture_.drawings();
    return depths_;
}

std::optional<NodePath> SurfaceView::leaf_at(glm::vec2 pointer, const Rect& view) const {
    const Ray ray = ray_at(pointer, view);
    return shows_view_ ? detail_surface_.leaf_at(ray) : surface_.leaf_at(ray);
}

void SurfaceView::show_value(const Session& session, const FamilyField& field, glm::vec2 pointer,
                             const Rect& view) {
    const Ray ray = ray_at(pointer, view);
    const std::optional<glm::vec3> value =
        shows_view_ ? detail_surface_.field_at(ray) : surface_.field_at(ray);
    if (!value) return;
    const bool is_scalar = field.label.kind == FieldKind::scalar;
    const glm::vec3 color =
        is_scalar ? session.display.scale.color(value->x) : encoded(glm::clamp(*value, 0.0F, 1.0F));
    const glm::ivec3 bytes(glm::round(255.0F * color));
    value_label(pointer, view, color,
                is_scalar
                    ? fmt::format("{} {}", field.label.name, shown_value(field, value->x))
                    : fmt::format("{} #{:02x}{:02x}{:02x}", field.label.name, bytes.r, bytes.g, bytes.b));
}

void SurfaceView::show_measured(const Session& session, glm::vec2 pointer, const Rect& view) {
    const Coloring coloring = session.display.coloring;
    if (!is_measured(coloring)) return;
    const UnionMesh& mesh = shows_view_ ? detail_surface_.mesh() : surface_.mesh();
    const std::optional<Hit> hit = first_hit(mesh.triangles, blend_positions(), ray_at(pointer, view));
    if (!hit) return;
    const std::optional<float> value = measured_.value_at(*hit, mesh);
    if (!value) return;
    value_label(pointer, view, measured_.scale().color(*value),
                coloring == Coloring::angle       ? fmt::format("smallest angle {:.1f}°", *value)
                : coloring == Coloring::curvature ? fmt::format("mean curvature {:.4g}", *value)
                                                  : fmt::format("moved by {:.4g}", *value));
}

Ray SurfaceView::ray_at(glm::vec2 pointer, const Rect& view) const {
    const glm::vec2 at = device_coordinates(view, pointer);
    const float aspect = aspect_of(view);
    return {camera_.point_at(at, 0, aspect), camera_.point_at(at, 1, aspect)};
}

std::optional<glm::vec3> SurfaceView::point_at(glm::vec2 pointer, const Rect& view) {
    OffscreenTarget& target = *picture_.target();
    const auto pixel = [](float part, int count) {
        return std::clamp(static_cast<int>(part * static_cast<float>(count)), 0, count - 1);
    };
    const float depth = target.depth_at(pixel((pointer.x - view.x) / view.width, target.width()),
                                        pixel((pointer.y - view.y) / view.height, target.height()));
    if (depth >= 1) return std::nullopt;
    return camera_.point_at(device_coordinates(view, pointer), depth, aspect_of(view));
}

float SurfaceView::shown_length(float length, const glm::vec3& point, const Rect& view) const {
    const glm::mat4 projection = camera_.projection(aspect_of(view));
    const glm::vec4 seen = camera_.view() * glm::vec4(point, 1);
    const glm::vec4 from = projection * seen;
    const glm::vec4 to = projection * (seen + glm::vec4(0, length, 0, 0));
    return std::abs(to.y / to.w - from.y / from.w) * view.height / 2;
}

void SurfaceView::reload_shaders() {
    surface_.renderer().reload_shaders();
    detail_surface_.renderer().reload_shaders();
    picture_.reload_shaders();
}

}  // namespace interleaf
