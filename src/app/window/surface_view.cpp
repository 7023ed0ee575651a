#include "app/window/surface_view.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <fmt/core.h>
#include <glm/common.hpp>

#include "app/window/camera_control.h"
#include "hierarchy/color.h"
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

}  // namespace

SurfaceView::SurfaceView() {
    camera_.look_from(30, 20);
}

void SurfaceView::apply_to_camera(const ViewInput& input, const Rect& view) {
    move_camera(camera_, input, view, picture_.target());
}

void SurfaceView::follow(const Session& session, const FamilyField* field, double now) {
    if (camera_ != last_camera_ || session.weights() != last_weights_) moved_at_ = now;
    last_weights_ = session.weights();
    want_details(session);
    const bool showed_view = shows_view_;
    shows_view_ = wants_view(session, now) && view_.follow(session.family(), session.weights(), details_);
    if (shows_view_) return;
    waits_ = false;
    if (showed_view) picture_.forget();  // so that the whole surface is drawn in its final quality at once
    detailed_.follow(session.family(), session.weights(), session.display.detail, details_);
    surface_.update(detailed_.family(), detailed_.weights(), field != nullptr ? &field->label : nullptr,
                    detailed_.sources());
    if (session.display.detail >= 1) surface_.expect(session.family(), session.next_key_sets());
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

void SurfaceView::aim(ViewTarget view_target, const Extent& all_keys, const Rect& view) {
    if (view_target == ViewTarget::surface)
        camera_.view_all(shows_view_ && view_.version() > 0 ? view_.extent() : surface_.extent(),
                         aspect_of(view));
    else if (view_target == ViewTarget::all_keys)
        camera_.view_all(all_keys, aspect_of(view));
    last_camera_ = camera_;
}

void SurfaceView::refine(const Session& session, const FamilyField* field, const Rect& view) {
    if (!shows_view_) return;
    view_.refine(session.family(), session.weights(), camera_, aspect_of(view),
                 field != nullptr ? &field->label : nullptr);
    view_figures_ = view_.figures();
    view_figures_.rebuilds = surface_.figures().rebuilds;
    view_figures_.waits = surface_.figures().waits;
}

bool SurfaceView::draw(const Session& session, const Rect& view, const Gui& gui, float window_height) {
    const auto pixels = [&](float length) { return static_cast<int>(std::lround(length * gui.density())); };
    Scene scene{.width = std::max(pixels(view.width), 1),
                .height = std::max(pixels(view.height), 1),
                .camera = camera_,
                .weights = shows_view_ ? std::vector{1.0F} : surface_.weights(),
                .display = session.display,
                .surface = surface_.figures().rebuilds,
                .view = shows_view_ ? view_.version() : 0};
    // What the renderer is given has its detail already.
    scene.display.detail = 1;
    scene.display.follows_camera = false;
    scene.display.line_width *= gui.scale() * gui.density();
    const bool is_good = picture_.update(shows_view_ ? view_.renderer() : surface_.renderer(), scene);
    if (!shows_view_ && session.display.detail >= 1) is_slow_ = picture_.milliseconds() > slow_whole_from;
    picture_.target()->blit_to_window(pixels(view.x), pixels(window_height - view.bottom()));
    return is_good && !surface_.figures().is_late;
}

void SurfaceView::show_value(const Session& session, const FamilyField& field, glm::vec2 pointer,
                             const Rect& view) {
    const glm::vec2 at = device_coordinates(view, pointer);
    const float aspect = aspect_of(view);
    const Ray ray{camera_.point_at(at, 0, aspect), camera_.point_at(at, 1, aspect)};
    const std::optional<glm::vec3> value = shows_view_ ? view_.field_at(ray) : surface_.field_at(ray);
    if (!value) return;
    const bool is_scalar = field.label.kind == FieldKind::scalar;
    const glm::vec3 color =
        is_scalar ? session.display.scale.color(value->x) : encoded(glm::clamp(*value, 0.0F, 1.0F));
    const glm::ivec3 bytes(glm::round(255.0F * color));
    value_label(pointer, view, color,
                is_scalar
                    ? fmt::format("{} {:.4g}", field.label.name, value->x)
                    : fmt::format("{} #{:02x}{:02x}{:02x}", field.label.name, bytes.r, bytes.g, bytes.b));
}

void SurfaceView::reload_shaders() {
    surface_.renderer().reload_shaders();
    view_.renderer().reload_shaders();
    picture_.forget();
}

}  // namespace interleaf
