// An offscreen framebuffer: sRGB color and depth, with or without multisampling. All drawing goes into one,
// with a window or without.
#pragma once

#include <cstdint>
#include <vector>

#include "render/gl_object.h"

namespace interleaf {

class OffscreenTarget {
  public:
    /// \param width    in pixels, at least 1
    /// \param height   in pixels, at least 1
    /// \param samples  1 for no multisampling, 4 for smooth silhouettes
    /// \throw MachineError if the machine cannot draw into a target of this size
    OffscreenTarget(int width, int height, int samples);

    int width() const { return width_; }
    int height() const { return height_; }

    /// Makes this the framebuffer to draw into, and sets its viewport.
    void bind() const;

    /// Copies the picture to the default framebuffer, with its lower left corner at (\p x, \p y), without
    /// color conversion.
    void blit_to_window(int x, int y);

    /// The picture: 8-bit RGBA, sRGB-encoded, top row first.
    std::vector<std::uint8_t> read_rgba();

    /// Copies the depths into \p framebuffer, whose depth buffer has the same size and 24 bits.
    void copy_depths(unsigned framebuffer);

    /// Waits until all drawing has finished.
    void finish() const;

    /// Depth at the pixel \p x, \p y (from the top): 0 at the near plane, 1 if nothing was drawn there.
    float depth_at(int x, int y);

    /// The depths of all pixels, top row first.
    std::vector<float> read_depths();

  private:
    void resolve(unsigned mask);
    unsigned readable() const { return samples_ > 1 ? resolved_framebuffer_.name() : framebuffer_.name(); }

    int width_;
    int height_;
    int samples_;
    GlRenderbuffer color_;
    GlRenderbuffer depth_;
    GlFramebuffer framebuffer_;
    GlRenderbuffer resolved_color_;  ///< one sample per pixel; only if framebuffer_ has more
    GlRenderbuffer resolved_depth_;
    GlFramebuffer resolved_framebuffer_;
};

}  // namespace interleaf
