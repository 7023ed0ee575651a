// The picture of the surface in the window. It is redrawn only when its scene changes: with one sample per
// pixel and without occlusion while the scene changes on a machine that draws slowly, with four as soon as it
// rests, and with occlusion when it has rested a moment.
#pragma once

#include <chrono>
#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include <glm/mat4x4.hpp>

#include "hierarchy/measure.h"
#include "render/camera.h"
#include "render/display.h"
#include "render/ground.h"
#include "render/occlusion.h"
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
    Box box;              ///< of all keys; the ground lies at its bottom
    std::size_t view;     ///< version number of the surface for the view; 0 if it is not drawn
    bool operator==(const Scene&) const = default;
};

class ScenePicture {
    using Clock = std::chrono::steady_clock;

  public:
    /// Updates the picture to \p scene.
    /// \return whether the picture has its final quality; otherwise it needs another update soon
    bool update(Renderer& renderer, const Scene& scene);

    /// Makes the next update draw even if the scene has not changed.
    void forget() { drawn_.reset(); }

    /// As forget(); also reads the shaders of the picture again.
    void reload_shaders();

    /// Duration of the last drawing.
    double milliseconds() const { return milliseconds_; }

    /// Counts the drawings.
    std::size_t drawings() const { return drawings_; }

    /// The drawn picture; null before the first update.
    OffscreenTarget* target() { return target_.get(); }

  private:
    /// From the fastest to draw to the final one.
    enum class Quality { coarse, smooth, shaded };

    Quality quality_while_moving() const;
    void draw(Renderer& renderer, const Scene& scene, Quality quality);
    void draw_ground(Renderer& renderer, const Scene& scene, Quality quality);

    std::unique_ptr<OffscreenTarget> target_;
    std::optional<Occlusion> occlusion_;  ///< made when first needed
    std::optional<Ground> ground_;        ///< made when first needed
    std::optional<Scene> shadow_of_;      ///< whose surface cast the shadow on the ground
    std::optional<Scene> drawn_;
    Quality quality_ = Quality::coarse;  ///< of the drawn picture
    int samples_ = 0;                    ///< per pixel of target_
    Clock::time_point changed_;          ///< when the scene last changed

    /// How long the last picture of the final quality took without occlusion, and with it.
    Clock::duration smooth_time_{};
    Clock::duration shaded_time_{};
    double milliseconds_ = 0;
    std::size_t drawings_ = 0;
};

}  // namespace interleaf
