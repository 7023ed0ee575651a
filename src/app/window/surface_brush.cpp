#include "app/window/surface_brush.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <glm/geometric.hpp>

namespace interleaf {

namespace {

/// Touches of a stroke per frame at most: each looks for the surface under the pointer.
constexpr int max_touches = 8;

/// The rays through the points between \p from and \p to, without \p from. Their distance is half the radius of the
/// brush, \p radius in screen coordinates, unless that takes too many of them.
std::vector<Ray> rays_between(glm::vec2 from, glm::vec2 to, float radius, const SurfaceView& surface,
                              const Rect& view) {
    const float wanted = std::ceil(glm::distance(from, to) / std::max(radius / 2, 1.0F));
    const int count = static_cast<int>(std::clamp(wanted, 0.0F, static_cast<float>(max_touches)));
    std::vector<Ray> rays;
    rays.reserve(static_cast<std::size_t>(count));
    for (int n = 1; n <= count; ++n)
        rays.push_back(
            surface.ray_at(from + (to - from) * (static_cast<float>(n) / static_cast<float>(count)), view));
    return rays;
}

}  // namespace

void SurfaceBrush::apply(const BrushResult& input, ViewerState& state, const SurfaceView& surface,
                         const Rect& view, double now) {
    if (input.begins) stroke_.begin(state, input.hold->coarsens);
    if (!stroke_.is_active()) return;
    if (state.brush.wants_to_cancel) return stroke_.cancel(state, now);
    if (!input.hold) return stroke_.end(state, now);
    const std::optional<std::size_t> key = brushed_key(state);
    const float radius =
        key && under_pointer_ ? surface.shown_length(brush_radius(state, *key), *under_pointer_, view) : 0;
    std::vector<Ray> rays = rays_between(input.from, input.hold->pointer, radius, surface, view);
    if (input.begins) rays.push_back(surface.ray_at(input.hold->pointer, view));
    // A union takes longer than a frame for large keys. While one is made, a newer one could not be shown.
    stroke_.touch(state, rays, !surface.figures().is_late, now);
}

void SurfaceBrush::draw(const ViewerState& state, SurfaceView& surface, const Rect& view, const Gui& gui) {
    under_pointer_.reset();
    const std::optional<std::size_t> key = brushed_key(state);
    if (!key) return;
    const glm::vec2 pointer = gui.pointer();
    const bool is_inside =
        pointer.x >= view.x && pointer.x < view.right() && pointer.y >= view.y && pointer.y < view.bottom();
    if (is_inside) under_pointer_ = surface.point_at(pointer, view);
    if (!under_pointer_) return;
    draw_brush_circle(view, pointer, surface.shown_length(brush_radius(state, *key), *under_pointer_, view),
                      stroke_.is_active());
}

}  // namespace interleaf
