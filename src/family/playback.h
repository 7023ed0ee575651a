// Playback: the animation's time as a function of wall time. It depends on no user interface and on no clock.
#pragma once

namespace interleaf {

class Playback {
  public:
    /// Paused at the beginning of the animation's interval [\p begin, \p end], in seconds.
    Playback(double begin, double end);

    /// The animation's time at wall time \p now, in seconds. A loop jumps from end() to begin(); without a
    /// loop the animation stays at end().
    double time(double now) const;

    /// Whether the animation is moving at \p now. It is not if it has reached the end without a loop.
    bool is_playing(double now) const;

    /// Continues from the current time, or from begin() if the animation has reached the end.
    void play(double now);
    void pause(double now);

    /// Jumps to \p time, clamped to the interval. A playing animation keeps playing.
    void seek(double time, double now);

    void set_loops(bool loops, double now);
    bool loops() const { return loops_; }

    /// Carries on with another interval, from the same time or the nearest time in it. Playback that is on
    /// stays on, from the beginning where the time is at the new end.
    /// \pre begin <= end
    void set_interval(double begin, double end, double now);

    double begin() const { return begin_; }
    double end() const { return end_; }

  private:
    double begin_;
    double end_;
    double anchor_time_;      ///< the animation's time ...
    double anchor_wall_ = 0;  ///< ... at this wall time
    bool playing_ = false;
    bool loops_ = true;
};

}  // namespace interleaf
