#include "family/playback.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

namespace interleaf {

namespace {

constexpr std::array offered_repeats{Repeat::once, Repeat::loop, Repeat::back_and_forth};

/// \p value modulo \p divisor, from 0 to \p divisor.
double modulo(double value, double divisor) {
    const double rest = std::fmod(value, divisor);
    return rest < 0 ? rest + divisor : rest;
}

}  // namespace

std::span<const Repeat> repeats() {
    return offered_repeats;
}

std::string_view name_of(Repeat repeat) {
    switch (repeat) {
        case Repeat::once:
            return "once";
        case Repeat::loop:
            return "loop";
        case Repeat::back_and_forth:
            return "back and forth";
    }
    return "";
}

Playback::Playback(double begin, double end)
    : begin_(begin), end_(end), begin_of_range_(begin), end_of_range_(end), anchor_{begin, false} {
    assert(begin <= end);
}

Playback::State Playback::state(double now) const {
    if (!playing_ || length() == 0) return anchor_;
    const double travelled = speed_ * std::max(now - anchor_wall_, 0.0);
    const double time = anchor_.backward ? anchor_.time - travelled : anchor_.time + travelled;
    if (begin_of_range_ <= time && time <= end_of_range_) return {time, anchor_.backward};
    switch (repeat_) {
        case Repeat::once:
            return {std::clamp(time, begin_of_range_, end_of_range_), anchor_.backward};
        case Repeat::loop:
            return {begin_of_range_ + modulo(time - begin_of_range_, length()), anchor_.backward};
        case Repeat::back_and_forth: {
            // Forth and back is one period; `phase` counts from the beginning of the range.
            const double phase = modulo(time - begin_of_range_, 2 * length());
            const bool is_mirrored = phase > length();
            return {is_mirrored ? end_of_range_ - (phase - length()) : begin_of_range_ + phase,
                    anchor_.backward != is_mirrored};
        }
    }
    return anchor_;
}

void Playback::anchor(State state, double now) {
    anchor_ = state;
    anchor_wall_ = now;
}

void Playback::anchor_at(double now) {
    const bool is_on = is_playing(now);
    anchor(state(now), now);
    playing_ = is_on;
}

double Playback::time(double now) const {
    return state(now).time;
}

bool Playback::goes_back(double now) const {
    return state(now).backward;
}

bool Playback::is_playing(double now) const {
    if (!playing_ || length() == 0) return false;
    if (repeat_ != Repeat::once) return true;
    const State present = state(now);
    return present.backward ? present.time > begin_of_range_ : present.time < end_of_range_;
}

void Playback::play(double now, bool backward) {
    double time_now = time(now);
    const double first = backward ? end_of_range_ : begin_of_range_;
    const double last = backward ? begin_of_range_ : end_of_range_;
    const bool is_outside = time_now < begin_of_range_ || time_now > end_of_range_;
    if (is_outside || (time_now == last && repeat_ != Repeat::back_and_forth)) time_now = first;
    anchor({time_now, backward}, now);
    playing_ = true;
}

void Playback::pause(double now) {
    anchor(state(now), now);
    playing_ = false;
}

void Playback::seek(double time, double now) {
    anchor_at(now);
    anchor_.time =
        playing_ ? std::clamp(time, begin_of_range_, end_of_range_) : std::clamp(time, begin_, end_);
}

void Playback::set_repeat(Repeat repeat, double now) {
    anchor_at(now);
    repeat_ = repeat;
}

void Playback::set_speed(double speed, double now) {
    anchor_at(now);
    speed_ = std::clamp(speed, min_speed, max_speed);
}

void Playback::set_range(std::optional<TimeRange> range, double now) {
    anchor_at(now);
    begin_of_range_ = range ? std::clamp(range->begin, begin_, end_) : begin_;
    end_of_range_ = range ? std::clamp(range->end, begin_, end_) : end_;
    has_range_ = begin_of_range_ < end_of_range_ && (begin_of_range_ > begin_ || end_of_range_ < end_);
    if (!has_range_) begin_of_range_ = begin_;
    if (!has_range_) end_of_range_ = end_;
    if (playing_) anchor_.time = std::clamp(anchor_.time, begin_of_range_, end_of_range_);
}

void Playback::set_interval(double begin, double end, double now) {
    assert(begin <= end);
    const State present = state(now);
    const bool was_playing = is_playing(now);
    const std::optional<TimeRange> old_range = has_range_ ? std::optional(range()) : std::nullopt;
    playing_ = false;
    begin_ = begin;
    end_ = end;
    set_range(old_range, now);
    anchor({std::clamp(present.time, begin_, end_), present.backward}, now);
    if (was_playing) play(now, present.backward);
}

}  // namespace interleaf
