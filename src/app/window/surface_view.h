// The surface of the document in the window: its camera, its picture, and the value under the pointer.
#pragma once

#include <array>
#include <optional>
#include <span>

#include <glm/vec2.hpp>

#include "app/document/session.h"
#include "app/document/viewer_state.h"
#include "app/document/viewpoint.h"
#include "app/pictures/detail_surface.h"
#include "app/pictures/detailed_family.h"
#include "app/pictures/key_details.h"
#include "app/pictures/measured_coloring.h"
#include "app/pictures/morph_surface.h"
#include "app/pictures/node_outline.h"
#include "app/pictures/scene_picture.h"
#include "app/pictures/vector_arrows.h"
#include "app/pictures/warped_family.h"
#include "family/family_fields.h"
#include "family/warp.h"
#include "hierarchy/buffer.h"
#include "hierarchy/measure.h"
#include "render/camera.h"
#include "render/pick.h"
#include "ui/gui.h"
#include "ui/panels/view_area.h"
#include "ui/widgets/rect.h"

namespace interleaf {

class SurfaceView {
  public:
    /// \pre an OpenGL context is current
    SurfaceView();

    /// Takes the extent of all keys of a document. The camera faces keys that lie in one plane, if those before did
    /// not.
    void set_extent(const Extent& all_keys);

    /// Makes \p up the vertical axis; the camera faces the plane of flat keys again.
    void set_up(UpAxis up);

    /// Whether all keys lie in one plane.
    bool is_flat() const { return axis_.has_value(); }

    /// Moves the camera by \p input, which was read over \p view.
    void apply_to_camera(const ViewInput& input, OrbitStyle style, const Rect& view);

    /// Updates the surface to \p session.
    /// \param field   the field that the session's display shows; null for none
    /// \param fields  of the family
    /// \param now     wall time, seconds
    void follow(const Session& session, const FamilyField* field, std::span<const FamilyField> fields,
                double now);

    /// Frames \p view_target: points the camera at the target, which then fills \p view.
    /// \pre follow() has been called
    void aim(ViewTarget view_target, const Rect& view);

    /// Takes over \p viewpoint for a picture in \p view.
    /// \pre follow() has been called
    void look(const Viewpoint& viewpoint, const Rect& view);

    /// Refines the surface for the picture in \p view, if its detail follows the camera.
    /// \pre follow() has been called for \p session and \p field
    void refine(const Session& session, const FamilyField* field, const Rect& view);

    /// Draws the surface into the window at \p view, behind the panels.
    /// \param window_height  screen coordinates
    /// \return whether the picture has its final quality; otherwise draw again soon
    bool draw(const Session& session, const Rect& view, const Gui& gui, float window_height);

    /// Draws the arrows of the session of the last follow(), over the picture of the last draw().
    void draw_arrows(const Rect& view, const Gui& gui);

    /// Draws the outline of \p node over the picture of the last draw().
    /// \param has_numbers  whether its corners have their numbers
    void draw_outline(const NodePath& node, bool has_numbers, const Rect& view, const Gui& gui);

    /// Whether parts turn on the surface that follow() has updated. A raised surface does not count: its positions
    /// are no blend.
    bool shows_turning() const;

    /// The corners of \p node on this surface; none where it is late.
    /// \pre shows_turning()
    std::optional<std::array<glm::vec3, 3>> turned_corners(const NodePath& node);

    /// The leaf of the shown surface at \p pointer in \p view; none beside the surface.
    std::optional<NodePath> leaf_at(glm::vec2 pointer, const Rect& view) const;

    /// Shows the value of \p field under \p pointer, or nothing if the pointer is not over the surface.
    void show_value(const Session& session, const FamilyField& field, glm::vec2 pointer, const Rect& view);

    /// Shows the value under \p pointer of a coloring by values that the blend determines; otherwise nothing.
    void show_measured(const Session& session, glm::vec2 pointer, const Rect& view);

    /// The scale of such a coloring.
    ColorScale measured_scale() const { return measured_.scale(); }
    /// The ray through \p pointer, window coordinates, over \p view.
    Ray ray_at(glm::vec2 pointer, const Rect& view) const;

    /// The point of the surface under \p pointer in the last picture; none beside the surface.
    /// \pre draw() has been called
    std::optional<glm::vec3> point_at(glm::vec2 pointer, const Rect& view);

    /// A length across the direction of view at \p point, in screen coordinates.
    float shown_length(float length, const glm::vec3& point, const Rect& view) const;

    /// Reloads the shaders. The next picture is drawn again even if nothing else has changed.
    void reload_shaders();

    const SurfaceFigures& figures() const { return shows_view_ ? view_figures_ : surface_.figures(); }
    const Camera& camera() const { return camera_; }
    Camera& camera() { return camera_; }

    /// Whether the shown surface has the detail that suits the camera.
    bool shows_view() const { return shows_view_; }

    /// The part of the keys that is measured for their detail; none if there is nothing to measure.
    std::optional<double> measured_part() const { return details_.progress(); }

    /// Whether another surface will be shown soon without any input.
    bool is_working() const { return waits_ || details_.progress(); }

  private:
    const std::vector<float>& depths();
    void follow_measured(const Session& session);
    Buffer<glm::vec3> blend_positions() const;
    void want_details(const Session& session);
    bool needs_whole(const Session& session, std::span<const FamilyField> fields) const;
    bool wants_view(const Session& session, double now);
    void follow_whole(const Session& session, const FamilyField* field, std::span<const FamilyField> fields);
    void face_plane();
    Extent raised_extent() const;  ///< \pre is_flat()
    Extent scene() const;

    Extent all_keys_;               ///< flat, if the keys are
    std::optional<unsigned> axis_;  ///< across the plane of all keys; none if they are not flat
    bool must_frame_ = false;       ///< the camera has turned to or from the plane
    KeyDetails details_;
    DetailedFamily detailed_;
    WarpedFamily warped_;
    MorphSurface surface_;
    DetailSurface detail_surface_;
    SurfaceFigures view_figures_;
    VectorArrows arrows_;
    MeasuredColoring measured_;
    NodeOutline outline_;
    std::vector<float> depths_;  ///< of the picture, once something needs them
    std::size_t depths_of_ = 0;  ///< number of the drawing that they are of
    ScenePicture picture_;
    Camera camera_;

    bool shows_view_ = false;  ///< detail_surface_, not surface_
    bool holds_view_ =
        false;            ///< shows detail_surface_ as it was, until the whole surface has been made and sent
    bool waits_ = false;  ///< shows detail_surface_ only until the surface rests and its union is made
    bool is_slow_ = false;  ///< whether the whole surface is too slow to move
    double moved_at_ = -1;  ///< wall time when camera or weights last changed, seconds
    Camera last_camera_;    ///< of the last frame
    Weights last_weights_;  ///< of the last frame
};

}  // namespace interleaf
