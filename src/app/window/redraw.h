// Counts the frames that the window still draws before it waits for input.
#pragma once

namespace interleaf {

/// The reasons why a frame needs later frames.
struct FrameRest {
    bool has_input = false;        ///< the frame had input from the mouse or the keyboard
    bool has_changed = false;      ///< the window's subject differs from the previous frame
    bool moves = false;            ///< the surface plays
    bool is_coarse = false;        ///< a picture of the surface does not have its final quality
    bool lacks_portraits = false;  ///< a picture of a key was drawn, and more may be missing
};

class Redraw {
  public:
    /// Adds the frames that Dear ImGui and the window need to settle after an event from outside the frame.
    void settle();

    /// Adds the frames that \p rest asks for.
    void follow(const FrameRest& rest);

    bool is_due() const { return frames_ > 0; }

    /// Begins one of the frames that are due.
    /// \pre is_due()
    void begin_frame() { --frames_; }

  private:
    /// Dear ImGui needs one more frame to settle, and a window may need one to appear.
    static constexpr int settling_frames = 3;

    int frames_ = settling_frames;
};

}  // namespace interleaf
