// Counts the small steps of long work and reports now and then. It counts steps, not time, so that the same
// input makes the same calls.
#pragma once

#include <cstddef>
#include <string_view>

#include "fit/mesh/progress.h"

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

    /// Some more work is done, in units of about 50 ns. \throw Cancelled when told to stop
    void step(std::size_t work = 20) {
        constexpr std::size_t interval = 20000;
        work_ += work;
        if (work_ < interval) return;
        work_ = 0;
        report();
    }

  private:
    void report() const {
        if (progress_ && !progress_(stage_, part_)) throw Cancelled();
    }

    const Progress& progress_;
    std::string_view stage_;
    double part_ = 0;
    std::size_t work_ = 0;
};

}  // namespace interleaf
