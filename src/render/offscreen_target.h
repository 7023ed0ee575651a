// A framebuffer of our own: sRGB colour and depth, multisampled or not. Everything is drawn into one, for the
// window and without.
#pragma once

#include <cstdint>
#include <vector>

#include "render/gl_object.h"

namespace interleaf {

class OffscreenTarget {
  public:
    /// \param width, height  pixels, at least 1
    /// \param samples        1 for none, 4 for smooth silhouettes
    /// \throw MachineError if the machine cannot draw into one of this size
    OffscreenTarget(int width, int height, int samples);

    int width() const { return width_; }
    int height() const { return height_; }

    /// Makes it the framebuffer that is drawn to, with its viewport.
    void bind() const;

    /// Copies what was drawn to the default framebuffer with its lower left corner at (\p x, \p y), value by
    /// value.
    void blit_to_window(int x, int y);

    /// What was drawn, 8-bit RGBA, sRGB-encoded, top row first.
    std::vector<std::uint8_t> read_rgba();

    /// Waits until everything has been drawn.
    void finish() const;

    /// Depth at the pixel \p x, \p y (from the top), 0 at the near plane; 1 where nothing was drawn.
    float depth_at(int x, int y);

    /// The same of all pixels, top row first.
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
    GlRenderbuffer resolved_color_;  ///< one sample a pixel; only where framebuffer_ has more
    GlRenderbuffer resolved_depth_;
    GlFramebuffer resolved_framebuffer_;
};

}  // namespace interleaf
