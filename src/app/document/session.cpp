#include "app/document/session.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "family/family_time.h"
#include "family/key_edits.h"

namespace interleaf {

std::string_view name_of(Driver driver) {
    switch (driver) {
        case Driver::timeline:
            return "timeline";
        case Driver::point:
            return "point";
        case Driver::key:
            return "key";
        case Driver::weights:
            return "weights";
    }
    return "";
}

Session::Session(std::shared_ptr<const Family> family) : family_(std::move(family)) {
    follow_interval(0);
    drive_with_what_there_is();
    advance(0);
}

bool Session::has_time() const {
    return source_of_time(*family_).has_value();
}

void Session::follow_interval(double now) {
    const auto source = source_of_time(*family_);
    const TimeRange interval = source ? interval_of(*family_, *source) : TimeRange{0, 0};
    playback_.set_interval(interval.begin, interval.end, now);
}

void Session::drive_with_what_there_is() {
    if (has_time()) {
        driver_ = Driver::timeline;
    } else if (family_->domain) {
        driver_ = Driver::point;
        if (!point_) point_ = family_->domain->locate(family_->domain->vertices().front().at);
    } else {
        driver_ = Driver::key;
        key_ = 0;
    }
}

void Session::replace_family(std::shared_ptr<const Family> family, double now) {
    advance(now);
    const Key single = family_->keys[key_];
    if (driver_ == Driver::weights) {
        weights_ = weights_in(*family, weights_);
        first_weights_ = weights_in(*family, first_weights_);
        if (first_weights_.empty()) first_weights_ = weights_;
    }
    family_ = std::move(family);
    key_ = place_after_change(family_->keys, single, key_).value_or(0);

    follow_interval(now);
    if (point_ && family_->domain) point_ = family_->domain->locate(point_->at, point_->triangle);
    const bool has_lost_driver = !can_drive(driver_) || (driver_ == Driver::weights && weights_.empty());
    if (has_lost_driver) drive_with_what_there_is();
    advance(now);
}

void Session::advance(double now) {
    now_ = now;
    switch (driver_) {
        case Driver::timeline:
            if (source_of_time(*family_) == TimeSource::path) {
                point_ = place_on_path(*family_, time());
                weights_ = family_->domain->weights(*point_);
                return;
            }
            weights_ = family_->timeline->at(time());
            break;
        case Driver::point:
            weights_ = family_->domain->weights(*point_);
            return;
        case Driver::key:
            weights_ = {{key_, 1.0}};
            break;
        case Driver::weights:
            break;
    }
    point_.reset();
    if (!family_->domain) return;
    if (const auto at = family_->domain->point_of(weights_)) point_ = family_->domain->locate(*at);
}

std::vector<std::vector<std::size_t>> Session::next_key_sets() const {
    const bool keys_drive = driver_ == Driver::timeline && source_of_time(*family_) == TimeSource::keys;
    if (keys_drive) return next_intervals();
    return driver_ == Driver::key || !point_ ? std::vector<std::vector<std::size_t>>{}
                                             : neighboring_triangles();
}

std::vector<std::vector<std::size_t>> Session::next_intervals() const {
    std::vector<std::vector<std::size_t>> sets;
    const Timeline& timeline = *family_->timeline;
    const auto keys = timeline.keys();
    const auto count = static_cast<std::ptrdiff_t>(keys.size());
    if (count < 2) return sets;
    const auto interval_of_time = [&](double time, bool ends_there) {
        const auto after = ends_there ? std::ranges::lower_bound(keys, time, {}, &TimelineKey::time)
                                      : std::ranges::upper_bound(keys, time, {}, &TimelineKey::time);
        return std::clamp<std::ptrdiff_t>(after - keys.begin() - 1, 0, count - 2);
    };
    const TimeRange range = playback_.range();
    const std::ptrdiff_t first = interval_of_time(range.begin, false);
    const std::ptrdiff_t intervals = interval_of_time(range.end, true) - first + 1;
    const std::ptrdiff_t here = interval_of_time(time(), false) - first;
    const std::ptrdiff_t ahead = plays_back() ? -1 : 1;
    // Two intervals ahead, for short ones, and the one behind. A loop goes around.
    for (const std::ptrdiff_t step : {ahead, 2 * ahead, -ahead}) {
        const std::ptrdiff_t next = here + step;
        const std::ptrdiff_t around = (next % intervals + intervals) % intervals;
        const bool loops = playback_.repeat() == Repeat::loop;
        const std::ptrdiff_t place =
            first + (loops ? around : std::clamp<std::ptrdiff_t>(next, 0, intervals - 1));
        sets.push_back(active_keys(timeline.at(keys[static_cast<std::size_t>(place)].time)));
    }
    return sets;
}

std::vector<std::vector<std::size_t>> Session::neighboring_triangles() const {
    std::vector<std::vector<std::size_t>> sets;
    const auto triangles = family_->domain->triangles();
    const auto shares_edge = [&](const Triangle& other) {
        return std::ranges::count_if(triangles[point_->triangle], [&](Index vertex) {
                   return std::ranges::find(other, vertex) != other.end();
               }) == 2;
    };
    for (Index t = 0; t < triangles.size(); ++t)
        if (shares_edge(triangles[t]))
            sets.push_back(active_keys(family_->domain->weights({{}, t, {1, 0, 0}})));
    return sets;
}

void Session::move_point(glm::dvec2 at, double now) {
    playback_.pause(now);
    point_ = family_->domain->locate(at, point_ ? point_->triangle : no_index);
    driving_point_ = point_->at;
    driver_ = Driver::point;
    advance(now);
}

void Session::show_key(std::size_t key, double now) {
    playback_.pause(now);
    key_ = key;
    driver_ = Driver::key;
    advance(now);
}

void Session::set_weights(Weights weights, double now) {
    advance(now);
    playback_.pause(now);
    if (driver_ != Driver::weights) first_weights_ = weights_;
    weights_ = std::move(weights);
    driver_ = Driver::weights;
    advance(now);
}

bool Session::can_drive(Driver driver) const {
    switch (driver) {
        case Driver::timeline:
            return has_time();
        case Driver::point:
            return family_->domain.has_value();
        case Driver::key:
        case Driver::weights:
            return true;
    }
    return false;
}

void Session::drive_by(Driver driver, double now) {
    advance(now);
    switch (driver) {
        case Driver::timeline:
            playback_.pause(now);
            return seek(playback_.time(now), now);
        case Driver::point:
            return move_point(driving_point_.value_or(family_->domain->vertices().front().at), now);
        case Driver::key:
            return show_key(key_, now);
        case Driver::weights:
            return set_weights(weights_, now);
    }
}

Weights Session::weights_in(const Family& family, const Weights& weights) const {
    Weights kept;
    kept.reserve(weights.size());
    std::vector<bool> is_taken(family.keys.size());
    for (const Weight& weight : weights) {
        // Two keys may share a hierarchy.
        const std::optional<std::size_t> key =
            place_after_change(family.keys, family_->keys[weight.key], weight.key, is_taken);
        if (!key) continue;
        is_taken[*key] = true;
        kept.push_back({*key, weight.value});
    }
    return sorted_weights(std::move(kept));
}

void Session::toggle_playing(double now, bool backward) {
    if (!has_time()) return;
    // Back and forth changes the direction by itself, so there any direction can be paused.
    const bool same_direction =
        playback_.goes_back(now) == backward || playback_.repeat() == Repeat::back_and_forth;
    if (playback_.is_playing(now) && same_direction) {
        playback_.pause(now);
    } else {
        playback_.play(now, backward);
    }
    driver_ = Driver::timeline;
    advance(now);
}

void Session::pause(double now) {
    playback_.pause(now);
    advance(now);
}

void Session::seek(double time, double now) {
    if (!has_time()) return;
    playback_.seek(time, now);
    driver_ = Driver::timeline;
    advance(now);
}

void Session::seek_key(int direction, double now) {
    if (!has_time()) return;
    const std::vector<double> times = marked_times(*family_, *source_of_time(*family_));
    if (direction > 0) {
        const auto next = std::ranges::upper_bound(times, time());
        seek(next == times.end() ? playback_.end() : *next, now);
    } else {
        const auto here = std::ranges::lower_bound(times, time());
        seek(here == times.begin() ? playback_.begin() : *(here - 1), now);
    }
}

void Session::step_frame(int direction, double now) {
    if (!has_time()) return;
    playback_.pause(now);
    const double begin = playback_.begin();
    // A time that is a frame's own but for rounding counts as that frame.
    constexpr double tolerance = 1e-6;
    const double frame = (playback_.time(now) - begin) * frame_rate;
    const double next = direction > 0 ? std::floor(frame + tolerance) + 1 : std::ceil(frame - tolerance) - 1;
    seek(begin + next / frame_rate, now);
}

void Session::set_repeat(Repeat repeat, double now) {
    if (!has_time()) return;
    playback_.set_repeat(repeat, now);
    advance(now);
}

void Session::set_speed(double speed, double now) {
    if (!has_time()) return;
    playback_.set_speed(speed, now);
    advance(now);
}

void Session::set_range(std::optional<TimeRange> range, double now) {
    if (!has_time()) return;
    playback_.set_range(range, now);
    advance(now);
}

}  // namespace interleaf
