// A fitted key and its mesh side by side in the window, seen by one camera, with their distances as colors.
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

/// What the person did in a comparison.
struct ComparisonActions {
    std::array<ViewInput, 2> sides;  ///< the mesh's, the key's
    ComparisonResult panel;
};

class ComparisonView {
  public:
    /// Follows \p state: the comparison that is shown from now on, in \p area, if \p state asks for one and
    /// has one. A pair that was not shown before is seen from where \p from looks. \pre a context is current
    void follow(ViewerState& state, const Rect& area, const Camera& from);

    /// Whether follow() has found a comparison to show instead of the document.
    bool is_shown() const { return is_shown_; }

    /// Shows the panel and the titles, and reads the mouse over both sides.
    /// \param has_keyboard  whether keys are for the comparison
    /// \pre is_shown(), for \p state
    ComparisonActions show(const ViewerState& state, bool has_keyboard) const;

    /// Moves the camera, and makes in \p state the choices of the panel.
    /// \pre \p actions are those of show() for \p state
    void apply(const ComparisonActions& actions, ViewerState& state);

    /// Draws both surfaces into the window, \p window_height high, behind the panels.
    /// \return whether the pictures are as good as they get; otherwise draw again soon
    /// \pre is_shown()
    bool draw(const Display& display, const Gui& gui, float window_height);

    /// The value under the pointer, and its place; call it after draw().
    void show_value() const;

    /// The next picture is drawn anew, whatever has changed.
    void reload_shaders();

    glm::vec3 eye() const { return camera_.eye(); }

  private:
    /// The mesh is the first, the key the second.
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
    std::size_t surface_ = 0;  ///< a number that changes with what is shown
    std::optional<std::array<Side, 2>> sides_;
    Extent extent_;
    Camera camera_;
    ColorScale scale_;
    bool has_colors_ = true;
    bool view_all_wanted_ = false;
    std::optional<glm::vec2> pointer_;  ///< that rests over a side
    std::size_t pointed_at_ = 0;        ///< which one
};

}  // namespace interleaf
