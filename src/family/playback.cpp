#include "family/playback.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace interleaf {

Playback::Playback(double begin, double end) : begin_(begin), end_(end), anchor_time_(begin) {
    assert(begin <= end);
}

double Playback::time(double now) const {
    if (!playing_) return anchor_time_;
    const double time = anchor_time_ + std::max(now - anchor_wall_, 0.0);
    if (time <= end_) return time;
    if (!loops_ || begin_ == end_) return end_;
    return begin_ + std::fmod(time - begin_, end_ - begin_);
}

bool Playback::is_playing(double now) const {
    return playing_ && begin_ < end_ && (loops_ || time(now) < end_);
}

void Playback::play(double now) {
    const double time_now = time(now);
    anchor_time_ = time_now < end_ ? time_now : begin_;
    anchor_wall_ = now;
    playing_ = true;
}

void Playback::pause(double now) {
    anchor_time_ = time(now);
    playing_ = false;
}

void Playback::seek(double time, double now) {
    playing_ = is_playing(now);
    anchor_time_ = std::clamp(time, begin_, end_);
    anchor_wall_ = now;
}

void Playback::set_loops(bool loops, double now) {
    seek(time(now), now);
    loops_ = loops;
}

void Playback::set_interval(double begin, double end, double now) {
    assert(begin <= end);
    const double time_now = time(now);
    const bool was_playing = is_playing(now);
    begin_ = begin;
    end_ = end;
    playing_ = false;
    seek(time_now, now);
    if (was_playing) play(now);
}

}  // namespace interleaf
