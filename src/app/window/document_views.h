// The views of the document: the surface or a comparison, the pictures of keys, and the pictures beside a
// message.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "app/document/inspection.h"
#include "app/document/viewer_state.h"
#include "app/pictures/blend_history.h"
#include "app/pictures/field_history.h"
#include "app/pictures/key_portraits.h"
#include "app/pictures/mismatch_pictures.h"
#include "app/window/comparison_view.h"
#include "app/window/frame_layout.h"
#include "app/window/key_views.h"
#include "app/window/redraw.h"
#include "app/window/surface_brush.h"
#include "app/window/surface_view.h"
#include "app/window/window_panels.h"
#include "family/family_fields.h"
#include "ui/gui.h"
#include "ui/timeline/weight_curves.h"

namespace interleaf {

class DocumentViews {
  public:
    /// \pre an OpenGL context is current
    DocumentViews() = default;

    /// Moves the cameras, and applies the choices of a comparison's panel to \p state.
    /// \pre the panels that returned \p actions showed \p state in \p layout
    void apply_to_views(const WindowActions& actions, ViewerState& state, const FrameLayout& layout);

    /// Applies the strokes of the brush to \p state.
    /// \pre as apply_to_views()
    void brush(const WindowActions& actions, ViewerState& state, const FrameLayout& layout, double now) {
        // Without the bar, such as in a comparison, the mouse holds no stroke.
        brush_.apply(actions.brush.value_or(BrushResult{}), state, surface_, layout.panels.view, now);
    }
    bool is_over_surface() const { return brush_.is_over_surface(); }

    /// Updates all views to \p state. Fulfills and clears its requests to move the camera and to reload the
    /// shaders. If the family lacks the displayed field, changes the display to one that the family supports.
    /// \param now  wall time, seconds
    void follow(ViewerState& state, const FrameLayout& layout, const Gui& gui, double now);

    /// Draws a missing picture of a key whose row, or whose vertex with room for it, is visible in \p shown.
    /// Each call draws at most one picture, so that the window stays responsive.
    /// \return whether a picture was missing
    bool draw_portrait(const WindowResult& shown, const Gui& gui);

    /// Draws the surface or the comparison behind the panels, and the value under the pointer.
    /// \param view  the mouse input over the surface
    /// \return whether the pictures have their final quality; otherwise draw again soon
    /// \pre follow() has been called for \p state
    bool draw(const ViewerState& state, const FrameLayout& layout, const std::optional<ViewInput>& view,
              const Gui& gui);

    /// The comparison that is shown instead of the document; null if there is none.
    const ComparisonView* comparison() const { return comparison_.is_shown() ? &comparison_ : nullptr; }

    const std::vector<KeyPortrait>& portraits() const { return portraits_.portraits(); }
    const std::vector<FamilyField>& fields() const { return fields_; }
    const std::vector<WeightCurve>& curves() const { return curves_; }
    /// The figures of the shown scalar over time, as far as they are measured.
    const FieldCurves& field_curves() { return history_.curves(); }
    /// Area, volume and leaves of the blend over time, as far as they are measured.
    const BlendCurves& blend_curves() { return blend_history_.curves(); }
    bool is_measuring() const { return history_.is_working(); }

    /// The scale of a coloring by values that the blend determines.
    ColorScale measured_scale() const { return surface_.measured_scale(); }

    /// Whether all keys lie in one plane.
    bool is_flat() const { return surface_.is_flat(); }
    const SurfaceFigures& figures() const { return surface_.figures(); }
    bool follows_camera() const { return surface_.shows_view(); }
    std::optional<double> measured_part() const { return surface_.measured_part(); }

    /// Whether the views will change soon without any input.
    bool is_working() const { return surface_.is_working() || blend_history_.is_working(); }

    const std::vector<MessagePicture>& message_pictures() const { return mismatch_pictures_.shown(); }

    /// The inspected node; null for none, and while a comparison is shown.
    const InspectedNode* inspected() const { return comparison() == nullptr ? inspection_.shown() : nullptr; }

    const Camera& camera() const { return surface_.camera(); }

    /// Position of the camera.
    glm::vec3 eye() const;

  private:
    /// What the curves of the timeline were made from.
    struct CurvesOf {
        TimeRange visible;
        std::size_t samples;
        bool operator==(const CurvesOf&) const = default;
    };
    void apply_to_key_views(const WindowActions& actions, ViewerState& state, const FrameLayout& layout);
    void point_at_leaf(const WindowActions& actions, const ViewerState& state, const FrameLayout& layout);
    void take_back_click(const ViewInput& input, ViewerState& state);
    void apply_to_inspection(const ViewInput& input, ViewerState& state, const Rect& view);
    void follow_inspection(ViewerState& state, const Rect& view);
    void reload_shaders(ViewerState& state);
    void follow_curves(const ViewerState& state, float width);
    void move_cameras(ViewerState& state, const FrameLayout& layout, double now);

    std::shared_ptr<const Family> family_;  ///< the family of the fields and portraits
    std::vector<FamilyField> fields_;
    std::vector<WeightCurve> curves_;
    std::optional<CurvesOf> curves_of_;  ///< none before curves_ are made for family_
    FieldHistory history_;
    BlendHistory blend_history_;
    SurfaceView surface_;
    Inspection inspection_;
    std::optional<NodePath> placed_node_;  ///< for which the inspector has found its place
    KeyViews key_views_;
    std::optional<NodePath> pointed_at_;  ///< the leaf under the pointer, while the keys are beside the blend
    /// Before the last press, if that was a click.
    std::optional<std::optional<NodePath>> inspected_before_click_;
    SurfaceBrush brush_;
    ComparisonView comparison_;
    KeyPortraits portraits_;
    MismatchPictures mismatch_pictures_;
    double spun_at_ = 0;  ///< wall time of the last frame, seconds
};

}  // namespace interleaf
