#include "app/window/document_views.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include <glm/common.hpp>

#include "app/document/shown_field.h"
#include "app/window/camera_control.h"
#include "family/family_time.h"
#include "ui/dialogs/message_panel.h"
#include "ui/timeline/timeline_panel.h"

namespace interleaf {

namespace {

constexpr double spin_speed = 20;          // degrees per second
constexpr double longest_spin_step = 0.1;  // seconds: a slow frame makes no jump

}  // namespace

void DocumentViews::apply_to_views(const WindowActions& actions, ViewerState& state,
                                   const FrameLayout& layout) {
    if (actions.view) {
        surface_.apply_to_camera(*actions.view, state.camera.orbit, layout.panels.view);
        apply_to_inspection(*actions.view, state, layout.panels.view);
    }
    apply_to_key_views(actions, state, layout);
    if (actions.axes) {
        surface_.camera().orbit(actions.axes->orbit, state.camera.orbit);
        if (const auto& from = actions.axes->look_from) surface_.camera().look_from_end(*from);
    }
    if (actions.comparison) comparison_.apply_to_comparison(*actions.comparison, state);
}

/// The pictures of keys move the camera as the surface does, and a click in one inspects the leaf there.
void DocumentViews::apply_to_key_views(const WindowActions& actions, ViewerState& state,
                                       const FrameLayout& layout) {
    const Rect& view = layout.panels.view;
    for (std::size_t n = 0; n < std::min(actions.key_views.size(), layout.key_views.size()); ++n) {
        const Rect& place = layout.key_views[n];
        ViewInput input = actions.key_views[n];
        take_back_click(input, state);
        if (input.clicked)
            inspected_before_click_ =
                std::exchange(state.inspected, key_views_.leaf_at(n, input.pointer, surface_.camera()));
        if (input.view_all) state.view_target = ViewTarget::surface;
        const glm::vec2 part =
            (input.pointer - glm::vec2(place.x, place.y)) / glm::vec2(place.width, place.height);
        input.pointer = glm::vec2(view.x, view.y) + part * glm::vec2(view.width, view.height);
        surface_.apply_to_camera(input, state.camera.orbit, view);
    }
    point_at_leaf(actions, state, layout);
}

void DocumentViews::point_at_leaf(const WindowActions& actions, const ViewerState& state,
                                  const FrameLayout& layout) {
    pointed_at_.reset();
    if (layout.key_views.empty() || state.inspected || state.session.is_playing()) return;
    if (actions.view && actions.view->pointed_at)
        pointed_at_ = surface_.leaf_at(actions.view->pointer, layout.panels.view);
    for (std::size_t n = 0; n < actions.key_views.size(); ++n)
        if (actions.key_views[n].pointed_at)
            pointed_at_ = key_views_.leaf_at(n, actions.key_views[n].pointer, surface_.camera());
}

/// A double-click is no click: it restores what its first press has changed.
void DocumentViews::take_back_click(const ViewInput& input, ViewerState& state) {
    if (input.view_all && inspected_before_click_)
        state.inspected = *std::exchange(inspected_before_click_, std::nullopt);
    if (input.pressed && !input.pressed_again) inspected_before_click_.reset();
}

/// A click on a leaf inspects it, a click beside the surface ends the inspection.
void DocumentViews::apply_to_inspection(const ViewInput& input, ViewerState& state, const Rect& view) {
    take_back_click(input, state);
    if (input.clicked && !state.brush.is_on)
        inspected_before_click_ = std::exchange(state.inspected, surface_.leaf_at(input.pointer, view));
}

/// \pre the surface follows \p state
void DocumentViews::follow_inspection(ViewerState& state, const Rect& view) {
    if (std::exchange(state.inspects_middle, false))
        state.inspected = surface_.leaf_at({view.x + view.width / 2, view.y + view.height / 2}, view);
    Inspection::TurnedCorners turned;
    if (surface_.shows_turning())
        turned = [this](const NodePath& node) { return surface_.turned_corners(node); };
    inspection_.follow(state, turned);
    const InspectedNode* const shown = inspection_.shown();
    const std::optional<NodePath> node = shown != nullptr ? std::optional(shown->node) : std::nullopt;
    if (std::exchange(placed_node_, node) == node || !node) return;
    const Camera& camera = surface_.camera();
    const glm::mat4 to_clip = camera.projection(aspect_of(view)) * camera.view();
    inspection_.set_at_left(std::ranges::any_of(shown->blend, [&](const glm::vec3& corner) {
        const glm::vec4 clip = to_clip * glm::vec4(corner, 1);
        return clip.w > 0 && is_at_left({view.x + view.width * (1 + clip.x / clip.w) / 2, view.y}, view);
    }));
}

void DocumentViews::follow(ViewerState& state, const FrameLayout& layout, const Gui& gui, double now) {
    if (std::exchange(state.reload_wanted, false)) reload_shaders(state);
    if (state.document.snapshot() != family_) {
        family_ = state.document.snapshot();
        inspected_before_click_.reset();
        portraits_.update(*family_);
        fields_ = fields_of(*family_);
        surface_.set_extent(portraits_.extent());
        curves_of_.reset();
    }
    state.session.display.light_background = state.appearance.theme == Theme::light;
    follow_curves(state, layout.panels.timeline.width);
    Session& session = state.session;
    adapt_display(session.display, fields_);
    const FamilyField* const field = shown_field(session.display, fields_);
    portraits_.set_look({.is_light = session.display.light_background,
                         .up = state.camera.up,
                         .field = field != nullptr ? std::optional(field->label) : std::nullopt,
                         .scale = field != nullptr ? session.display.scale : ColorScale{}});
    const bool is_scalar = field != nullptr && field->label.kind == FieldKind::scalar;
    history_.follow(family_, is_scalar ? &field->label.name : nullptr);
    // A drag ends with a family of its own; those on the way to it are not measured.
    if (!state.is_dragging || !state.plots_blend)
        blend_history_.follow(state.plots_blend ? family_ : nullptr);
    move_cameras(state, layout, now);
    surface_.follow(session, field, fields_, now);
    comparison_.follow(state, layout.content, surface_.camera());
    if (!comparison_.is_shown())
        surface_.aim(std::exchange(state.view_target, ViewTarget::none), layout.panels.view);
    if (const auto wanted = std::exchange(state.camera_wishes.viewpoint, std::nullopt))
        surface_.look(*wanted, layout.panels.view);
    surface_.refine(session, field, layout.panels.view);
    follow_inspection(state, layout.panels.view);
    key_views_.follow(session, layout.key_views, field);
    const glm::vec2 size = message_picture_size() * gui.density();
    mismatch_pictures_.update(state.message.mismatch, glm::max(glm::ivec2(glm::round(size)), 1));
}

/// Moves the camera as the commands say, and spins it.
void DocumentViews::move_cameras(ViewerState& state, const FrameLayout& layout, double now) {
    CameraWishes& wishes = state.camera_wishes;
    Camera& camera = comparison_.is_shown() ? comparison_.camera() : surface_.camera();
    camera.set_projection(state.camera.projection);
    comparison_.camera().set_up(state.camera.up);
    surface_.set_up(state.camera.up);
    for (const auto& move : std::exchange(wishes.moves, {})) move(camera);
    const double elapsed = std::clamp(now - spun_at_, 0.0, longest_spin_step);
    spun_at_ = now;
    if (state.camera.spins && !state.is_dragging) camera.turn(static_cast<float>(spin_speed * elapsed));
    const float zoom = std::exchange(wishes.zoom, 1.0F);
    if (zoom == 1) return;
    const Rect& view = comparison_.is_shown() ? comparison_.view() : layout.panels.view;
    ViewInput input;
    input.zoom = zoom;
    input.pointer = {view.x + view.width / 2, view.y + view.height / 2};
    if (comparison_.is_shown())
        camera.zoom(zoom, {0, 0}, 1);
    else
        surface_.apply_to_camera(input, state.camera.orbit, view);
}

void DocumentViews::follow_curves(const ViewerState& state, float width) {
    const std::optional<TimeSource> source = source_of_time(*family_);
    if (!source) return curves_.clear();
    const CurvesOf wanted{shown_times(interval_of(*family_, *source), state.shown_times),
                          curve_samples(width)};
    if (wanted == curves_of_) return;
    curves_ = weight_curves(*family_, *source, wanted.visible, wanted.samples);
    curves_of_ = wanted;
}

void DocumentViews::reload_shaders(ViewerState& state) {
    try {
        surface_.reload_shaders();
        key_views_.reload_shaders();
        comparison_.reload_shaders();
    } catch (const std::runtime_error& error) {
        state.message = message_of(error);
    }
}

bool DocumentViews::draw_portrait(const WindowResult& shown, const Gui& gui) {
    if (!shown.actions.keys) return false;
    const int side = static_cast<int>(std::lround(key_picture_side() * gui.density()));
    const auto draw_missing = [&](std::size_t key) { return portraits_.draw_next(key, key + 1, side); };
    if (std::ranges::any_of(shown.actions.keys->visible, draw_missing)) return true;
    return shown.actions.domain && std::ranges::any_of(shown.actions.domain->pictured, draw_missing);
}

bool DocumentViews::draw(const ViewerState& state, const FrameLayout& layout,
                         const std::optional<ViewInput>& view, const Gui& gui) {
    const Session& session = state.session;
    if (comparison_.is_shown()) {
        const bool is_good = comparison_.draw(session.display, gui, layout.window.y);
        comparison_.show_value();
        return is_good;
    }
    bool is_good = surface_.draw(session, layout.view, gui, layout.window.y);
    is_good &=
        key_views_.draw(session.display, surface_.measured_scale(), surface_.camera(), gui, layout.window.y);
    surface_.draw_arrows(layout.view, gui);
    const auto node = inspected() != nullptr ? std::optional(inspected()->node) : pointed_at_;
    if (node) surface_.draw_outline(*node, inspected() != nullptr, layout.view, gui);
    key_views_.draw_marks(surface_.camera(), node, gui);
    brush_.draw(state, surface_, layout.view, gui);
    const FamilyField* const field = shown_field(session.display, fields_);
    if (field != nullptr && view && view->pointed_at && !session.is_playing())
        surface_.show_value(session, *field, gui.pointer(), layout.view);
    if (view && view->pointed_at && !session.is_playing())
        surface_.show_measured(session, gui.pointer(), layout.view);
    return is_good;
}

glm::vec3 DocumentViews::eye() const {
    return (comparison_.is_shown() ? comparison_.camera() : surface_.camera()).eye();
}

}  // namespace interleaf
