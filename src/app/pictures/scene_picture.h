// The picture of the surface in the window: drawn again only when what it shows has changed, with one sample
// a pixel while it moves on a machine that is slow at it, and with four as soon as it rests.
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

/// What is to be seen.
struct Scene {
    int width;   ///< pixels
    int height;  ///< pixels
    Camera camera;
    std::vector<float> weights;
    Display display;
    std::size_t surface;  ///< a number that changes with the uploaded surface
    bool operator==(const Scene&) const = default;
};

class ScenePicture {
  public:
    /// Brings the picture up to date.
    /// \return whether it is as good as it gets; otherwise it wants another update soon
    bool update(Renderer& renderer, const Scene& scene);

    /// The next update draws, whatever has changed.
    void forget() { drawn_.reset(); }

    /// What was drawn; null before the first update.
    OffscreenTarget* target() { return target_.get(); }

  private:
    void draw(Renderer& renderer, const Scene& scene, int samples);

    std::unique_ptr<OffscreenTarget> target_;
    std::optional<Scene> drawn_;
    int samples_ = 0;       ///< of target_
    bool is_slow_ = false;  ///< at drawing with all samples
};

}  // namespace interleaf
