#include "app/window/surface_view.h"

#include <algorithm>
#include <cmath>

#include <fmt/core.h>
#include <glm/common.hpp>

#include "app/window/camera_control.h"
#include "hierarchy/color.h"
#include "ui/widgets/value_label.h"

namespace interleaf {

SurfaceView::SurfaceView() {
    camera_.look_from(30, 20);
}

void SurfaceView::apply_to_camera(const ViewInput& input, const Rect& view) {
    move_camera(camera_, input, view, picture_.target());
}

void SurfaceView::follow(const Session& session, const FamilyField* field) {
    detailed_.follow(session.family(), session.weights(), session.display.detail);
    surface_.update(detailed_.family(), detailed_.weights(), field != nullptr ? &field->label : nullptr,
                    detailed_.sources());
    if (session.display.detail >= 1) surface_.expect(session.family(), session.next_key_sets());
}

void SurfaceView::aim(ViewTarget view_target, const Extent& all_keys, const Rect& view) {
    if (view_target == ViewTarget::surface)
        camera_.view_all(surface_.extent(), aspect_of(view));
    else if (view_target == ViewTarget::all_keys)
        camera_.view_all(all_keys, aspect_of(view));
}

bool SurfaceView::draw(const Session& session, const Rect& view, const Gui& gui, float window_height) {
    const auto pixels = [&](float length) { return static_cast<int>(std::lround(length * gui.density())); };
    Scene scene{.width = std::max(pixels(view.width), 1),
                .height = std::max(pixels(view.height), 1),
                .camera = camera_,
                .weights = surface_.weights(),
                .display = session.display,
                .surface = surface_.figures().rebuilds};
    scene.display.line_width *= gui.scale() * gui.density();
    const bool is_good = picture_.update(surface_.renderer(), scene);
    picture_.target()->blit_to_window(pixels(view.x), pixels(window_height - view.bottom()));
    return is_good && !surface_.figures().is_late;
}

void SurfaceView::show_value(const Session& session, const FamilyField& field, glm::vec2 pointer,
                             const Rect& view) {
    const glm::vec2 at = device_coordinates(view, pointer);
    const float aspect = aspect_of(view);
    const Ray ray{camera_.point_at(at, 0, aspect), camera_.point_at(at, 1, aspect)};
    const std::optional<glm::vec3> value = surface_.field_at(ray);
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
    picture_.forget();
}

}  // namespace interleaf
