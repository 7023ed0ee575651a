// Counts the small steps of long work and reports from time to time. The meter counts steps, not time, so
// that the same input causes the same calls.
#pragma once

#include <cstddef>
#include <string_view>

#include "hierarchy/progress.h"

namespace interleaf {

class ProgressMeter {
  public:
    explicit ProgressMeter(const Progress& progress) : progress_(progress) {}

    /// Reports that \p stage begins, with the fraction \p part of the whole done.
    /// \throw Cancelled if progress says so
    void enter(std::string_view stage, double part) {
        stage_ = stage;
        part_ = part;
        report();
    }

    /// Sets the fraction of the whole that is done. A later step reports it.
    void set_part(double part) { part_ = part; }

    /// Counts \p work, in units of about 50 ns.
    /// \throw Cancelled if progress says so
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
