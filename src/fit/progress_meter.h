// Counts the steps of one stage of long work and reports them now and then. It counts steps, not time, so that
// the same input makes the same calls.
#pragma once

#include <cstddef>
#include <string_view>

#include "fit/progress.h"

namespace interleaf {

/// Reports \p part of \p stage. \throw Cancelled when told to stop
inline void report(const Progress& progress, std::string_view stage, double part) {
    if (progress && !progress(stage, part)) throw Cancelled();
}

class ProgressMeter {
  public:
    /// Reports from \p from to \p to of the whole while \p steps steps are done, every \p interval steps.
    ProgressMeter(const Progress& progress, std::string_view stage, double from, double to, std::size_t steps,
                  std::size_t interval)
        : progress_(progress), stage_(stage), from_(from), to_(to), steps_(steps), interval_(interval) {
        report(progress_, stage_, from_);
    }

    /// One more step is done. \throw Cancelled when told to stop
    void step() {
        if (++done_ % interval_ != 0) return;
        const double part = done_ < steps_ ? double(done_) / double(steps_) : 1;
        report(progress_, stage_, from_ + (to_ - from_) * part);
    }

  private:
    const Progress& progress_;
    std::string_view stage_;
    double from_;
    double to_;
    std::size_t steps_;
    std::size_t interval_;
    std::size_t done_ = 0;
};

}  // namespace interleaf
