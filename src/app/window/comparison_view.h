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
#include "ui/widgets/rect.h"

namespace interleaf {

class ComparisonView {
  public:
    /// Shows the comparison that \p state has come to, and its panel, in \p area: instead of the document.
    /// Choices made there, and the wish to go back, go into \p state. What is compared is seen from where
    /// \p from looks when it is not the pair of the frame before.
    /// \param takes_keyboard  whether the keyboard is for it
    /// \pre a context is current; state.is_comparing, with something to compare
    void show(ViewerState& state, const Rect& area, const Camera& from, bool takes_keyboard);

    /// Draws both surfaces into the window, \p window_height high, below what show() has put there.
    /// \return whether the pictures are as good as they get; otherwise draw again soon
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
    void show_side(Side& side, const char* name);

    std::shared_ptr<const FitComparison> shown_;
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
