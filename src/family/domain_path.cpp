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

/// A deviation, with the Gaussian about time 0 at its time.
struct WeightedDeviation {
    Deviation deviation;
    double share;    ///< integral of the Gaussian from 0
    double density;  ///< of the Gaussian
};

/// \param deviation  its time is counted in standard deviations
WeightedDeviation weighted(const Deviation& deviation) {
    return {deviation, 0.5 * std::erf(deviation.time / std::numbers::sqrt2),
            std::exp(-0.5 * deviation.time * deviation.time) / std::sqrt(2 * std::numbers::pi)};
}

/// The integral of a linear function of time, given at both ends of an interval, times a Gaussian.
glm::dvec2 gaussian_integral(const WeightedDeviation& from, const WeightedDeviation& to) {
    const double first = from.deviation.time;
    const double last = to.deviation.time;
    if (!(last > first)) return glm::dvec2(0);  // two times that became equal by rounding
    const glm::dvec2 slope = (to.deviation.at - from.deviation.at) / (last - first);
    const glm::dvec2 at_center = from.deviation.at - slope * first;
    return at_center * (to.share - from.share) + slope * (from.density - to.density);
}

/// The filter over the deviations of a path.
class DeviationFilter {
  public:
    /// \param deviations  at least two, the first at time 0; 0 at both ends
    /// \param sigma  standard deviation of the Gaussian, seconds
    DeviationFilter(std::span<const Deviation> deviations, double sigma)
        : deviations_(deviations), continued_(deviations), sigma_(sigma) {}

    /// The deviation after the filter.
    /// \param time  from the first to the last time
    glm::dvec2 operator()(double time) const {
        const auto next = std::ranges::upper_bound(deviations_, time, {}, &Deviation::time);
        const bool is_last = next == deviations_.end();
        const std::ptrdiff_t place = next - deviations_.begin();
        const glm::dvec2 here = is_last ? deviations_.back().at : between(*(next - 1), *next, time);
        return half(time, here, place, 1) + half(time, here, place - 1, -1);
    }

  private:
    static constexpr double window = 6;  ///< standard deviations; the rest of the Gaussian is 2e-9

    /// One side of the integral: from \p time over the deviations from \p place on.
    /// \param step  1 towards later times, -1 towards earlier ones
    glm::dvec2 half(double time, glm::dvec2 here, std::ptrdiff_t place, std::ptrdiff_t step) const {
        glm::dvec2 sum(0);
        WeightedDeviation near = weighted({0, here});
        for (; std::abs(near.deviation.time) < window; place += step) {
            const Deviation next = continued_[place];
            const WeightedDeviation far = weighted({(next.time - time) / sigma_, next.at});
            sum += step > 0 ? gaussian_integral(near, far) : gaussian_integral(far, near);
            near = far;
        }
        return sum;
    }

    std::span<const Deviation> deviations_;
    ContinuedDeviations continued_;
    double sigma_;
};

/// Samples of the filtered deviation at equal intervals, and a polynomial between them. A filtered function
/// bends so little within a fifth of a standard deviation that polynomials of degree 7 differ from it by
/// about a millionth of the largest deviation.
class SampledFilter {
  public:
    /// The number of intervals that the samples of \p duration need.
    static double interval_count(double duration, double sigma) { return std::ceil(5 * duration / sigma); }

    SampledFilter(const DeviationFilter& filter, double duration, std::ptrdiff_t intervals)
        : interval_(duration / static_cast<double>(intervals)) {
        samples_.reserve(static_cast<std::size_t>(intervals) + 1);
        for (std::ptrdiff_t i = 0; i <= intervals; ++i)
            samples_.push_back(filter(duration * static_cast<double>(i) / static_cast<double>(intervals)));
        samples_.front() = samples_.back() = glm::dvec2(0);
    }

    glm::dvec2 operator()(double time) const {
        constexpr std::ptrdiff_t count = 8;
        const double place = time / interval_;
        const auto first = static_cast<std::ptrdiff_t>(place) - (count / 2 - 1);
        glm::dvec2 sum(0);
        for (std::ptrdiff_t i = first; i < first + count; ++i) {
            double factor = 1;
            for (std::ptrdiff_t other = first; other < first + count; ++other)
                if (other != i)
                    factor *= (place - static_cast<double>(other)) / static_cast<double>(i - other);
            sum += factor * sample(i);
        }
        return sum;
    }

  private:
    /// Sample \p place, also beyond the ends, where the deviations are reflected.
    glm::dvec2 sample(std::ptrdiff_t place) const {
        const std::ptrdiff_t last = std::ssize(samples_) - 1;
        const std::ptrdiff_t phase = (place % (2 * last) + 2 * last) % (2 * last);
        return phase <= last ? samples_[static_cast<std::size_t>(phase)]
                             : -samples_[static_cast<std::size_t>(2 * last - phase)];
    }

    double interval_;
    std::vector<glm::dvec2> samples_;
};

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
    const DeviationFilter filter(deviations, sigma);
    const auto smooth_by = [&](const auto& smooth) {
        for (std::size_t i = 1; i + 1 < points.size(); ++i)
            points[i].at += smooth(deviations[i].time) - deviations[i].at;
    };
    // Where points are dense, samples take less time than the points themselves.
    const double duration = deviations.back().time;
    const double intervals = SampledFilter::interval_count(duration, sigma);
    if (intervals < static_cast<double>(points.size()))
        smooth_by(SampledFilter(filter, duration, static_cast<std::ptrdiff_t>(intervals)));
    else
        smooth_by(filter);
    return DomainPath(std::move(points));
}

}  // namespace interleaf
