// A framebuffer of our own: sRGB colour and depth, multisampled or not. Everything is drawn into one, for the window and without.
#pragma once

#include <cstdint>
#include <vector>

#include "render/gl_object.h"

namespace interleaf {

class OffscreenTarget {
  public:
    /// \param width, height  pixels, at least 1
    /// \param samples        1 for none, 4 for smooth silhouettes
    OffscreenTarget(int width, int height, int samples);

    int width() const { return width_; }
    int height() const { return height_; }

    /// Makes it the framebuffer that is drawn to, with its viewport.
    void bind() const;

    /// Copies what was drawn to the default framebuffer with its lower left corner at (\p x, \p y).
    void blit_to_window(int x, int y);

    /// What was drawn, 8-bit RGBA, top row first.
    std::vector<std::uint8_t> read_rgba();

  private:
    void resolve();

    int width_;
    int height_;
    int samples_;
    // handles: see gl_object.h
};

}  // namespace interleaf
