#include "app/session.h"

#include <algorithm>
#include <utility>

namespace interleaf {

Session::Session(Family family) : family_(std::move(family)) {
    if (family_.timeline) {
        playback_.emplace(family_.timeline->begin(), family_.timeline->end());
        driver_ = Driver::timeline;
        advance(0);
    } else if (family_.domain) {
        move_point(family_.domain->vertices().front().at, 0);
    }
}

void Session::advance(double now) {
    if (!playback_) return;
    time_ = playback_->time(now);
    playing_ = playback_->is_playing(now);
    if (driver_ != Driver::timeline) return;
    weights_ = family_.timeline->at(time_);
    point_.reset();
    if (!family_.domain) return;
    if (const auto at = family_.domain->point_of(weights_)) point_ = family_.domain->locate(*at);
}

void Session::move_point(glm::dvec2 at, double now) {
    if (playback_) playback_->pause(now);
    driver_ = Driver::point;
    point_ = family_.domain->locate(at, point_ ? point_->triangle : no_index);
    weights_ = family_.domain->weights(*point_);
    advance(now);
}

void Session::toggle_playing(double now) {
    if (!playback_) return;
    if (playback_->is_playing(now)) {
        playback_->pause(now);
    } else {
        playback_->play(now);
    }
    driver_ = Driver::timeline;
    advance(now);
}

void Session::seek(double time, double now) {
    if (!playback_) return;
    playback_->seek(time, now);
    driver_ = Driver::timeline;
    advance(now);
}

void Session::seek_key(int direction, double now) {
    if (!playback_) return;
    const auto keys = family_.timeline->keys();
    const auto time_of = [](const TimelineKey& key) { return key.time; };
    if (direction > 0) {
        const auto next = std::ranges::upper_bound(keys, time_, {}, time_of);
        seek(next == keys.end() ? playback_->end() : next->time, now);
    } else {
        const auto here = std::ranges::lower_bound(keys, time_, {}, time_of);
        seek(here == keys.begin() ? playback_->begin() : (here - 1)->time, now);
    }
}

void Session::toggle_loop(double now) {
    if (!playback_) return;
    playback_->set_loops(!playback_->loops(), now);
    advance(now);
}

}  // namespace interleaf
