// Says what must be drawn again: how many frames the window still draws before it waits for input.
#pragma once

namespace interleaf {

/// What a frame leaves to later frames.
struct FrameRest {
    bool has_input = false;        ///< mouse or keys did something in the frame
    bool has_changed = false;      ///< what the window is about is not what it was in the frame before
    bool moves = false;            ///< the surface plays
    bool is_coarse = false;        ///< a picture of the surface can be drawn better
    bool lacks_portraits = false;  ///< a picture of a key was drawn, and more may be missing
};

class Redraw {
  public:
    /// Something has come from outside the frame: draws until Dear ImGui and the window have settled.
    void settle();

    /// Adds the frames that \p rest asks for.
    void follow(const FrameRest& rest);

    bool is_due() const { return frames_ > 0; }

    /// One frame of those that are due begins.
    /// \pre is_due()
    void begin_frame() { --frames_; }

  private:
    void draw_at_least(int frames);

    /// Dear ImGui needs one more frame to settle, and a window may need one to appear.
    static constexpr int settling_frames = 3;

    int frames_ = settling_frames;
};

}  // namespace interleaf
