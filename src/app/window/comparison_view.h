// The comparison of a fitted key with its mesh: both surfaces side by side in the window, seen by one camera,
// with their distances as colors.
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "app/document/fit_comparison.h"
#include "app/document/viewer_state.h"
#include "app/pictures/scene_picture.h"
#include "render/camera.h"
#include "render/renderer.h"
#include "ui/gui.h"
#include "ui/panels/comparison_panel.h"
#include "ui/panels/view_area.h"
#include "ui/widgets/rect.h"

namespace interleaf {

/// The user's actions in a comparison.
struct ComparisonActions {
    std::array<ViewInput, 2> sides;  ///< of the mesh, of the key
    ComparisonResult panel;
};

class ComparisonView {
  public:
    /// Adopts the comparison that \p state asks for, if there is one, and lays it out in \p area.
    /// \param from  the first comparison takes over the view direction of this camera
    /// \pre an OpenGL context is current
    void follow(ViewerState& state, const Rect& area, const Camera& from);

    /// Whether follow() found a comparison, which the window then shows instead of the document.
    bool is_shown() const { return is_shown_; }

    /// Shows the panel and the titles, and reads the mouse over both sides.
    /// \param has_keyboard  whether the comparison receives the keyboard
    /// \pre is_shown(), for \p state
    ComparisonActions show(const ViewerState& state, bool has_keyboard) const;

    /// Moves the camera, and applies the choices of the panel to \p state.
    /// \pre show() returned \p actions for \p state
    void apply_to_comparison(const ComparisonActions& actions, ViewerState& state);

    /// Draws both surfaces into the window, behind the panels.
    /// \param window_height  screen coordinates
    /// \return whether the pictures have their final quality; otherwise draw again soon
    /// \pre is_shown()
    bool draw(const Display& display, const Gui& gui, float window_height);

    /// Shows the value under the pointer, at the pointer.
    /// \pre draw() has been called in this frame
    void show_value() const;

    /// Reloads the shaders. The next pictures are drawn again even if nothing else has changed.
    void reload_shaders();

    const Camera& camera() const { return camera_; }
    Camera& camera() { return camera_; }

    /// The sides of the last frame share this place of the window.
    Rect view() const { return sides_ ? sides_->front().view : Rect{}; }

  private:
    /// One half of the window: the first side shows the mesh, the second side shows the key.
    struct Side {
        Renderer renderer;
        ScenePicture picture;
        UnionMesh mesh;  ///< with the distances as its only field
        Rect view;
        std::string title;
    };

    void take(std::shared_ptr<const FitComparison> comparison, std::string_view key_name, const Camera& from);
    void place(const Rect& area);

    bool is_shown_ = false;
    std::shared_ptr<const FitComparison> shown_;
    Rect panel_;
    std::size_t surface_ = 0;  ///< number of the shown pair; changes with the pair
    std::optional<std::array<Side, 2>> sides_;
    Extent extent_;
    Camera camera_;
    ColorScale scale_;
    bool has_colors_ = true;
    bool view_all_wanted_ = false;
    std::optional<glm::vec2> pointer_;  ///< where the pointer rests over a side; none if it does not
    std::size_t pointed_at_ = 0;        ///< the side under the pointer
};

}  // namespace interleaf
