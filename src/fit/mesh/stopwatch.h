// Times of the stages of long work.
#pragma once

#include <chrono>
#include <string>
#include <utility>
#include <vector>

namespace interleaf {

/// How long a stage took.
struct StageTime {
    std::string stage;
    double seconds;
};

class Stopwatch {
  public:
    /// \param times  gets a time at each lap
    explicit Stopwatch(std::vector<StageTime>& times) : times_(times) {}

    /// Ends the stage that began at the last call, or when the stopwatch was made.
    void lap(std::string stage) {
        const auto now = std::chrono::steady_clock::now();
        times_.push_back({std::move(stage), std::chrono::duration<double>(now - begin_).count()});
        begin_ = now;
    }

  private:
    std::vector<StageTime>& times_;
    std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

}  // namespace interleaf
