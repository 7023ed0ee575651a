// The timeline: keys at given times, and the weights between them (paper, section 3.1, equation (2)).
#pragma once

#include <span>
#include <vector>

#include "family/weights.h"

namespace interleaf {

struct TimelineKey {
    double time;      ///< in seconds
    std::size_t key;  ///< index of the key in its family
    bool operator==(const TimelineKey&) const = default;
};

class Timeline {
  public:
    /// \throw InputError unless there is at least one key and times are finite and strictly ascending
    explicit Timeline(std::vector<TimelineKey> keys);

    std::span<const TimelineKey> keys() const { return keys_; }
    double begin() const { return keys_.front().time; }
    double end() const { return keys_.back().time; }

    /// Linear interpolation between the keys before and after \p time, clamped to begin() and end(): (1 - s)
    /// and s on the two keys of the interval. At the time of a key, the interval that begins there counts. A
    /// single key, or two adjacent entries of the same key, give one weight of 1.
    /// \throw InputError if \p time is not a number
    Weights at(double time) const;

    bool operator==(const Timeline&) const = default;

  private:
    std::vector<TimelineKey> keys_;
};

}  // namespace interleaf
