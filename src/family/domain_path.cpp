#include "family/domain_path.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <utility>

#include <fmt/core.h>
#include <glm/geometric.hpp>

#include "hierarchy/error.h"

namespace interleaf {

namespace {

bool is_finite(const PathPoint& point) {
    return std::isfinite(point.time) && std::isfinite(point.at.x) && std::isfinite(point.at.y);
}

void check_points(std::span<const PathPoint> points) {
    if (points.empty()) throw InputError("the path has no point; it needs at least one");
    if (points.size() > DomainPath::max_points)
        throw InputError(fmt::format("the path has {} points, expected at most {}", points.size(),
                                     DomainPath::max_points));
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (!is_finite(points[i]))
            throw InputError(fmt::format("the time or the place of path point {} is not finite", i));
        if (i > 0 && points[i].time <= points[i - 1].time)
            throw InputError(fmt::format(
                "path point {} is at time {}, but times must ascend and the point before it is at {}", i,
                points[i].time, points[i - 1].time));
    }
    const double begin = points.front().time;
    const double end = points.back().time;
    if (!std::isfinite(end - begin))
        throw InputError(
            fmt::format("the times of the path, {:.10g} to {:.10g}, are too far apart", begin, end));
}

/// Inserts \p added behind the points that are not later.
void insert(std::vector<PathPoint>& points, const PathPoint& added) {
    points.insert(std::ranges::upper_bound(points, added.time, {}, &PathPoint::time), added);
}

/// The point at \p time of the straight motion from \p from to \p to.
glm::dvec2 between(const PathPoint& from, const PathPoint& to, double time) {
    const double part = (time - from.time) / (to.time - from.time);
    return (1 - part) * from.at + part * to.at;
}

/// A deviation from the straight motion, at a time.
using Deviation = PathPoint;

/// The deviations of a path, continued beyond both ends. A reflection at an end reverses time and sign, so
/// the continuation has a period of twice the path's duration.
class ContinuedDeviations {
  public:
    /// \param deviations  at least two, the first at time 0; 0 at both ends
    explicit ContinuedDeviations(std::span<const Deviation> deviations) : deviations_(deviations) {}

    /// Entry \p place of the continuation, where 0 is the path's first point and negative places are earlier.
    Deviation operator[](std::ptrdiff_t place) const {
        const std::ptrdiff_t half = std::ssize(deviations_) - 1;
        const std::ptrdiff_t phase = (place % (2 * half) + 2 * half) % (2 * half);
        const double duration = deviations_.back().time;
        const std::ptrdiff_t halves = (place - phase) / half;  // exact
        const double shift = duration * static_cast<double>(halves);
        if (phase <= half) {
            const Deviation& own = deviations_[static_cast<std::size_t>(phase)];
            return {shift + own.time, own.at};
        }
        const Deviation& mirrored = deviations_[static_cast<std::size_t>(2 * half - phase)];
        return {shift + 2 * duration - mirrored.time, -mirrored.at};
    }

  private:
    std::span<const Deviation> deviations_;
};

/// The integral of a linear function of time, given at both ends of an interval, times a Gaussian.
/// \param sigma  standard deviation of the Gaussian, whose center is the time 0
glm::dvec2 gaussian_integral(const Deviation& from, const Deviation& to, double sigma) {
    if (!(to.time > from.time)) return glm::dvec2(0);  // two times that became equal by rounding
    const double first = from.time / sigma;
    const double last = to.time / sigma;
    const glm::dvec2 slope = (to.at - from.at) / (last - first);
    const glm::dvec2 at_center = from.at - slope * first;
    const double share = 0.5 * (std::erf(last / std::numbers::sqrt2) - std::erf(first / std::numbers::sqrt2));
    const double moment =
        (std::exp(-0.5 * first * first) - std::exp(-0.5 * last * last)) / std::sqrt(2 * std::numbers::pi);
    return at_center * share + slope * moment;
}

/// The deviation at \p place after the filter.
glm::dvec2 smoothed_deviation(const ContinuedDeviations& deviations, std::ptrdiff_t place, double sigma) {
    constexpr double window = 6;  // standard deviations; the rest of the Gaussian is 2e-9
    const double center = deviations[place].time;
    const auto centered = [&](std::ptrdiff_t other) {
        const Deviation deviation = deviations[other];
        return Deviation{deviation.time - center, deviation.at};
    };
    glm::dvec2 sum(0);
    for (const std::ptrdiff_t step : {-1, 1}) {
        Deviation near = centered(place);
        for (std::ptrdiff_t other = place + step; std::abs(near.time) < window * sigma; other += step) {
            const Deviation far = centered(other);
            sum += step > 0 ? gaussian_integral(near, far, sigma) : gaussian_integral(far, near, sigma);
            near = far;
        }
    }
    return sum;
}

}  // namespace

DomainPath::DomainPath(std::vector<PathPoint> points) : points_(std::move(points)) {
    check_points(points_);
}

glm::dvec2 DomainPath::at(double time) const {
    if (std::isnan(time)) throw InputError("the time is not a number");
    const auto next = std::ranges::upper_bound(points_, time, {}, &PathPoint::time);
    if (next == points_.begin()) return points_.front().at;
    if (next == points_.end()) return points_.back().at;
    return between(*(next - 1), *next, time);
}

DomainPath DomainPath::with_point(const PathPoint& added) const {
    std::vector<PathPoint> points = points_;
    insert(points, added);
    return DomainPath(std::move(points));
}

DomainPath DomainPath::with_point_moved(std::size_t place, const PathPoint& to) const {
    std::vector<PathPoint> points = points_;
    points.erase(points.begin() + static_cast<std::ptrdiff_t>(place));
    insert(points, to);
    return DomainPath(std::move(points));
}

std::optional<DomainPath> DomainPath::without_point(std::size_t place) const {
    if (points_.size() == 1) return std::nullopt;
    std::vector<PathPoint> points = points_;
    points.erase(points.begin() + static_cast<std::ptrdiff_t>(place));
    return DomainPath(std::move(points));
}

// Between two times of the original points, both paths are straight motions, so their distance is convex in
// time. It is therefore enough to measure it at these times.
DomainPath simplified(const DomainPath& path, double tolerance) {
    if (!(tolerance >= 0)) throw InputError("the tolerance of the path is not a number from 0 on");
    const auto points = path.points();
    std::vector<bool> is_kept(points.size(), false);
    is_kept.front() = is_kept.back() = true;
    std::vector<std::pair<std::size_t, std::size_t>> open{{0, points.size() - 1}};
    while (!open.empty()) {
        const auto [first, last] = open.back();
        open.pop_back();
        std::size_t farthest = first;
        double distance = tolerance;
        for (std::size_t i = first + 1; i < last; ++i) {
            const double here =
                glm::distance(points[i].at, between(points[first], points[last], points[i].time));
            if (here <= distance) continue;
            farthest = i;
            distance = here;
        }
        if (farthest == first) continue;
        is_kept[farthest] = true;
        open.emplace_back(first, farthest);
        open.emplace_back(farthest, last);
    }
    std::vector<PathPoint> kept;
    for (std::size_t i = 0; i < points.size(); ++i)
        if (is_kept[i]) kept.push_back(points[i]);
    return DomainPath(std::move(kept));
}

DomainPath smoothed(const DomainPath& path, double seconds) {
    if (!(seconds >= 0)) throw InputError("the seconds to smooth over are not a number from 0 on");
    std::vector<PathPoint> points(path.points().begin(), path.points().end());
    if (points.size() < 3 || seconds == 0) return path;
    // Twice the duration leaves a billionth of any deviation already.
    const double sigma = std::min(seconds, 2 * (path.end() - path.begin()));
    std::vector<Deviation> deviations = points;
    for (Deviation& deviation : deviations) {
        deviation.at -= between(points.front(), points.back(), deviation.time);
        deviation.time -= path.begin();
    }
    deviations.front().at = deviations.back().at = glm::dvec2(0);
    const ContinuedDeviations continued(deviations);
    for (std::size_t i = 1; i + 1 < points.size(); ++i)
        points[i].at +=
            smoothed_deviation(continued, static_cast<std::ptrdiff_t>(i), sigma) - deviations[i].at;
    return DomainPath(std::move(points));
}

}  // namespace interleaf
