// Measures how long the stages of long work take.
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
    /// \param times  receives one entry per lap; must outlive this object
    explicit Stopwatch(std::vector<StageTime>& times) : times_(times) {}

    /// Ends the present stage, which began at the last call or when the stopwatch was made.
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
