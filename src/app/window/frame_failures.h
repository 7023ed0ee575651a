// Decides whether the window goes on after a frame that ended with an exception.
#pragma once

#include <utility>

namespace interleaf {

/// The window outlives an exception, which may come from a rare state. An exception in the very next frame
/// would come in each frame from then on, so it ends the program.
class FrameFailures {
  public:
    /// \param outlives_first  false where nobody watches the window, so that every exception ends the program
    explicit FrameFailures(bool outlives_first) : outlives_first_(outlives_first) {}

    /// To be called after a frame without an exception.
    void note_success() { has_failed_ = false; }

    /// To be called after a frame that ended with an exception.
    /// \return whether the window goes on
    bool outlives_failure() { return !std::exchange(has_failed_, true) && outlives_first_; }

  private:
    bool outlives_first_;
    bool has_failed_ = false;  ///< whether the last frame failed
};

}  // namespace interleaf
