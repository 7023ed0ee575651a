// Playback: the animation's time as a function of wall time. It depends on no user interface and on no clock.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace interleaf {

/// What happens at the end of the played range.
enum class Repeat : std::uint8_t {
    once,            ///< the animation stops
    loop,            ///< it jumps to the other end
    back_and_forth,  ///< it turns around
};

/// All ways to repeat, in the order in which they are offered.
std::span<const Repeat> repeats();

/// "back and forth".
std::string_view name_of(Repeat repeat);

/// A range of the animation's time, in its unit: that of the timeline (TimeUnit), or seconds of a path.
struct TimeRange {
    double begin;
    double end;
    bool operator==(const TimeRange&) const = default;
};

/// Limits of the speed: units of the animation's time per second.
inline constexpr double min_speed = 1.0 / 64;
inline constexpr double max_speed = 8;

class Playback {
  public:
    /// Paused at the beginning of the animation's interval [\p begin, \p end].
    Playback(double begin, double end);

    /// The animation's time at wall time \p now; wall times are seconds.
    double time(double now) const;

    /// Whether the animation is moving at \p now. It is not if it has stopped at the end of the range.
    bool is_playing(double now) const;

    /// Whether the animation goes, or would go, from later to earlier times at \p now.
    bool goes_back(double now) const;

    /// Continues from the current time. From a time outside the played range, and from its end where the
    /// animation would stop at once, it begins at the other end of the range.
    /// \param backward  whether time runs backward; the animation keeps this direction until the next play()
    void play(double now, bool backward = false);
    void pause(double now);

    /// Jumps to \p time, clamped to the interval, or to the played range while the animation is playing. A
    /// playing animation keeps playing.
    void seek(double time, double now);

    void set_repeat(Repeat repeat, double now);
    Repeat repeat() const { return repeat_; }

    /// \param speed  seconds of the animation per second; clamped to min_speed and max_speed
    void set_speed(double speed, double now);
    double speed() const { return speed_; }

    /// The times that are played: those from the in point to the out point, clamped to the interval; by
    /// default the interval.
    TimeRange range() const { return {begin_of_range_, end_of_range_}; }

    /// Whether the range is a part of the interval that set_range() has set.
    bool has_range() const { return has_range_; }

    /// Sets the in and out points; none for the whole interval. A range without length counts as none. A
    /// playing animation outside the range jumps into it.
    void set_range(std::optional<TimeRange> range, double now);

    /// Carries on with another interval, from the same time or the nearest time in it, and with the part of
    /// the range that is in it. Playback that is on stays on, from the beginning where the time is at the new
    /// end.
    /// \pre begin <= end
    void set_interval(double begin, double end, double now);

    double begin() const { return begin_; }
    double end() const { return end_; }

  private:
    /// A time and the direction of travel there.
    struct State {
        double time;
        bool backward;
    };
    State state(double now) const;
    void anchor(State state, double now);

    /// Anchors the present state. Playback that has stopped at an end is off from then on.
    void anchor_at(double now);
    double length() const { return end_of_range_ - begin_of_range_; }

    double begin_;
    double end_;
    double begin_of_range_;
    double end_of_range_;
    State anchor_;            ///< the animation's state ...
    double anchor_wall_ = 0;  ///< ... at this wall time
    double speed_ = 1;
    Repeat repeat_ = Repeat::loop;
    bool has_range_ = false;
    bool playing_ = false;
};

}  // namespace interleaf
