// How far long work is: one line on standard error that is written over, where that is a terminal.
#pragma once

#include <chrono>
#include <string_view>

namespace interleaf {

class ProgressLine {
  public:
    ProgressLine();
    ~ProgressLine();  ///< wipes the line
    ProgressLine(const ProgressLine&) = delete;
    ProgressLine& operator=(const ProgressLine&) = delete;

    /// \p what is done now; \p part of the whole, 0 to 1, is done already. An estimate of the time left comes
    /// from that, after the first second.
    void show(std::string_view what, double part);

  private:
    using Clock = std::chrono::steady_clock;

    bool is_terminal_;
    bool is_shown_ = false;
    Clock::time_point begin_ = Clock::now();
    Clock::time_point last_{};
};

}  // namespace interleaf
