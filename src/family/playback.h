// Playback: time of the animation as a function of wall time. It knows no user interface and no clock.
#pragma once

namespace interleaf {

class Playback {
  public:
    /// Paused at \p begin of the animation's interval [\p begin, \p end], in seconds.
    Playback(double begin, double end);

    /// The animation's time at wall time \p now, in seconds. A loop goes from end() to begin() at once;
    /// without it the animation rests at end().
    double time(double now) const;

    /// Whether it moves at \p now: false also when it has come to the end without a loop.
    bool is_playing(double now) const;

    /// Starts from where it is; from begin() when it rests at the end.
    void play(double now);
    void pause(double now);

    /// Jumps to \p time, clamped to the interval; goes on playing when it was playing.
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
