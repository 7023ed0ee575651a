// The picture of the surface in the window. It is redrawn only when its scene changes: with one sample per
// pixel while the scene changes on a machine that draws slowly, and with four as soon as it rests.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include <glm/mat4x4.hpp>

#include "render/camera.h"
#include "render/display.h"
#include "render/offscreen_target.h"
#include "render/renderer.h"

namespace interleaf {

/// The content of the picture.
struct Scene {
    int width;   ///< pixels
    int height;  ///< pixels
    Camera camera;
    std::vector<float> weights;
    Display display;
    std::size_t surface;  ///< version number of the uploaded surface
    std::size_t view;     ///< version number of the surface for the view; 0 if it is not drawn
    bool operator==(const Scene&) const = default;
};

class ScenePicture {
  public:
    /// Updates the picture to \p scene.
    /// \return whether the picture has its final quality; otherwise it needs another update soon
    bool update(Renderer& renderer, const Scene& scene);

    /// Makes the next update draw even if the scene has not changed.
    void forget() { drawn_.reset(); }

    /// Duration of the last drawing.
    double milliseconds() const { return milliseconds_; }

    /// The drawn picture; null before the first update.
    OffscreenTarget* target() { return target_.get(); }

  private:
    void draw(Renderer& renderer, const Scene& scene, int samples);

    std::unique_ptr<OffscreenTarget> target_;
    std::optional<Scene> drawn_;
    int samples_ = 0;       ///< per pixel of target_
    bool is_slow_ = false;  ///< whether drawing with all samples is slow
    double milliseconds_ = 0;
};

}  // namespace interleaf
