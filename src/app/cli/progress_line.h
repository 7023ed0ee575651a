// The progress of long work: one line on standard error that is overwritten, only where that is a terminal.
#pragma once

#include <chrono>
#include <string_view>

namespace interleaf {

class ProgressLine {
  public:
    ProgressLine();
    ~ProgressLine();  ///< erases the line
    ProgressLine(const ProgressLine&) = delete;
    ProgressLine& operator=(const ProgressLine&) = delete;

    /// Shows the progress. After the first second the line also estimates the remaining time.
    /// \param what  the present stage of the work
    /// \param part  the part of the whole work that is done, 0 to 1
    void show(std::string_view what, double part);

  private:
    using Clock = std::chrono::steady_clock;

    bool is_terminal_;
    bool is_shown_ = false;
    Clock::time_point begin_ = Clock::now();
    Clock::time_point last_{};
};

}  // namespace interleaf
