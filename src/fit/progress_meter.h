// Counts the small steps of long work and reports now and then. It counts steps, not time, so that the same
// input makes the same calls.
#pragma once

#include <cstddef>
#include <string_view>

#include "fit/progress.h"

namespace interleaf {

class ProgressMeter {
  public:
    explicit ProgressMeter(const Progress& progress) : progress_(progress) {}

    /// Reports that \p stage is reached, with \p part of the whole done. \throw Cancelled when told to stop
    void enter(std::string_view stage, double part) {
        stage_ = stage;
        part_ = part;
        report();
    }

    /// From now on \p part of the whole is done, to be reported with some later step.
    void set_part(double part) { part_ = part; }

    /// One more step is done: some microseconds of work. \throw Cancelled when told to stop
    void step() {
        constexpr std::size_t interval = 1024;
        if (++steps_ % interval == 0) report();
    }

  private:
    void report() const {
        if (progress_ && !progress_(stage_, part_)) throw Cancelled();
    }

    const Progress& progress_;
    std::string_view stage_;
    double part_ = 0;
    std::size_t steps_ = 0;
};

}  // namespace interleaf
