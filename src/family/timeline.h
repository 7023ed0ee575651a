// The timeline: keys at given times, and the weights between them (paper, sections 3.1 and 4.1, equations (2)
// and (4)).
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "family/interpolation.h"
#include "family/weights.h"

namespace interleaf {

/// What the times of a timeline count. Playback at normal speed takes a second per unit.
enum class TimeUnit : std::uint8_t {
    seconds,
    steps,  ///< of a numbered series
};

/// "seconds" or "steps".
std::string_view name_of(TimeUnit unit);

/// The unit called \p name; none when there is none.
std::optional<TimeUnit> time_unit_named(std::string_view name);

/// "2.5 s", or "step 2.5" without a unit.
/// \param unit  as people write it
std::string time_text(double time, std::string_view unit);

class Timeline {
  public:
    /// \throw InputError unless there is at least one key and times are finite and strictly ascending
    explicit Timeline(std::vector<TimelineKey> keys, Interpolation interpolation = {},
                      TimeUnit unit = TimeUnit::seconds);

    std::span<const TimelineKey> keys() const { return keys_; }
    const Interpolation& interpolation() const { return interpolation_; }
    TimeUnit unit() const { return unit_; }
    double begin() const { return keys_.front().time; }
    double end() const { return keys_.back().time; }

    /// The weights of the interpolation at \p time, clamped to begin() and end(). At the time of a key, the
    /// interval that begins there counts. A single key has the weight 1.
    /// \throw InputError if \p time is not a number
    Weights at(double time) const;

    /// The place of the entry at \p time; none when there is no such entry.
    std::optional<std::size_t> place_at(double time) const;

    /// Edits. Each gives the changed timeline, which keeps everything but the entries that the edit names. So
    /// whatever a timeline comes to hold, an edit loses none of it.
    /// @{

    /// With \p added, too.
    /// \throw InputError as the constructor
    Timeline with_entry(TimelineKey added) const;

    /// With the entry \p place at \p time. The entry may pass others.
    /// \throw InputError as the constructor
    Timeline with_time(std::size_t place, double time) const;

    /// Without the entry \p place; none if it is the only one.
    std::optional<Timeline> without_entry(std::size_t place) const;

    /// Without the entries of \p key; none if there are no others.
    std::optional<Timeline> without_key(std::size_t key) const;

    /// With another interpolation.
    Timeline with_interpolation(Interpolation interpolation) const;

    /// With the same times in another unit.
    Timeline with_unit(TimeUnit unit) const;

    /// With the index \p new_index(i) for each key index i.
    Timeline with_keys_renumbered(const std::function<std::size_t(std::size_t)>& new_index) const;

    /// @}

    bool operator==(const Timeline&) const = default;

  private:
    Timeline with_entries(std::vector<TimelineKey> keys) const;
    void check() const;

    std::vector<TimelineKey> keys_;
    Interpolation interpolation_;
    TimeUnit unit_ = TimeUnit::seconds;
};

}  // namespace interleaf
