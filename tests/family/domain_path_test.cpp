// Tests of paths through a parameter domain: the motion, edits, simplification and smoothing.
#include "family/domain_path.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include "numbers.h"
#include "thrown_errors.h"
#include "trials.h"
#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "hierarchy/error.h"

using namespace interleaf;

namespace {

constexpr double not_a_time = std::numeric_limits<double>::quiet_NaN();

/// A path with \p count points at uneven times; neighbors are near each other.
DomainPath random_path(std::mt19937& random, std::size_t count) {
    std::uniform_real_distribution<double> seconds(0.01, 0.1);
    std::normal_distribution<double> step(0, 0.05);
    std::vector<PathPoint> points{{-1.5, {0.25, 0.5}}};
    while (points.size() < count) {
        const PathPoint& last = points.back();
        points.push_back({last.time + seconds(random), last.at + glm::dvec2(step(random), step(random))});
    }
    return DomainPath(std::move(points));
}

DomainPath path_with(std::vector<PathPoint> points) {
    return DomainPath(std::move(points));
}

std::vector<PathPoint> points_of(const DomainPath& path) {
    return {path.points().begin(), path.points().end()};
}

/// The largest distance at any time: where both paths are straight motions, the distance is convex.
double largest_distance(const DomainPath& a, const DomainPath& b) {
    double largest = 0;
    for (const auto& points : {points_of(a), points_of(b)})
        for (const PathPoint& point : points)
            largest = std::max(largest, glm::distance(a.at(point.time), b.at(point.time)));
    return largest;
}

/// The smoothed path by its definition: a sum over small steps of the deviation from the straight motion,
/// reflected at the ends, times the Gaussian.
glm::dvec2 smoothed_literally(const DomainPath& path, double sigma, double time) {
    const double begin = path.begin();
    const double duration = path.end() - begin;
    const glm::dvec2 first = path.points().front().at;
    const glm::dvec2 last = path.points().back().at;
    const auto straight = [&](double t) { return first + (last - first) * ((t - begin) / duration); };
    const auto deviation = [&](double t) {
        double phase = std::fmod(t - begin, 2 * duration);
        if (phase < 0) phase += 2 * duration;
        const bool is_mirrored = phase > duration;
        const double inside = begin + (is_mirrored ? 2 * duration - phase : phase);
        return (is_mirrored ? -1.0 : 1.0) * (path.at(inside) - straight(inside));
    };
    glm::dvec2 sum(0);
    double weights = 0;
    const double step = sigma / 500;
    for (double offset = -7 * sigma; offset <= 7 * sigma; offset += step) {
        const double weight = std::exp(-0.5 * offset * offset / (sigma * sigma));
        sum += weight * deviation(time + offset);
        weights += weight;
    }
    return straight(time) + sum / weights;
}

}  // namespace

TEST_CASE("a path moves straight and evenly from point to point, and rests beyond its ends") {
    const DomainPath path({{1, {0, 0}}, {3, {4, -2}}, {4, {4, 6}}});
    CHECK(path.begin() == 1);
    CHECK(path.end() == 4);
    CHECK(path.at(1) == glm::dvec2(0, 0));
    CHECK(path.at(1.5) == glm::dvec2(1, -0.5));
    CHECK(path.at(3) == glm::dvec2(4, -2));
    CHECK(path.at(3.25) == glm::dvec2(4, 0));
    CHECK(path.at(4) == glm::dvec2(4, 6));
    CHECK(path.at(-infinity) == glm::dvec2(0, 0));
    CHECK(path.at(infinity) == glm::dvec2(4, 6));
    CHECK_THROWS_AS(path.at(not_a_time), InputError);
    CHECK(path_with({{7, {1, 2}}}).at(0) == glm::dvec2(1, 2));
}

TEST_CASE("a path passes through each of its points at that point's time") {
    for (unsigned seed = 0; seed < 10; ++seed) {
        CAPTURE(seed);
        std::mt19937 random(seed);
        const DomainPath path = random_path(random, 50);
        for (const PathPoint& point : path.points()) CHECK(path.at(point.time) == point.at);
    }
}

TEST_CASE("a path has a point, finite numbers, ascending times and a limited number of points") {
    CHECK(input_error_of([] { path_with({}); }) == "the path has no point; it needs at least one");
    const std::string not_finite = "the time or the place of path point 1 is not finite";
    for (const PathPoint& point : {PathPoint{infinity, {0, 0}}, PathPoint{not_a_time, {0, 0}},
                                   PathPoint{1, {infinity, 0}}, PathPoint{1, {0, not_a_time}}})
        CHECK(input_error_of([&] { path_with({{0, {0, 0}}, point}); }) == not_finite);
    for (const double second : {2.0, 1.0})
        CHECK(input_error_of([&] {
                  path_with({{2, {0, 0}}, {second, {1, 1}}});
              }).starts_with("path point 1 is at time "));
    CHECK(input_error_of([] {
              path_with({{-1e308, {0, 0}}, {1e308, {1, 1}}});
          }) == "the times of the path, -1e+308 to 1e+308, are too far apart");
    std::vector<PathPoint> many;
    for (std::size_t i = 0; i < DomainPath::max_points; ++i) many.push_back({static_cast<double>(i), {0, 0}});
    CHECK(path_with(many).points().size() == DomainPath::max_points);
    many.push_back({1e9, {0, 0}});
    CHECK(input_error_of([&] { path_with(many); }) == "the path has 65537 points, expected at most 65536");
}

TEST_CASE("an edit changes the point that it names, and no other") {
    const PathPoint a{0, {0, 0}};
    const PathPoint b{1, {1, 0}};
    const PathPoint c{2, {1, 1}};
    const DomainPath path({a, b, c});
    CHECK(points_of(path.with_point({1.5, {9, 9}})) == std::vector<PathPoint>{a, b, {1.5, {9, 9}}, c});
    CHECK(points_of(path.with_point({-1, {9, 9}})) == std::vector<PathPoint>{{-1, {9, 9}}, a, b, c});
    CHECK_THROWS_AS(path.with_point({1, {9, 9}}), InputError);
    CHECK_THROWS_AS(path.with_point({3, {infinity, 9}}), InputError);
    CHECK(points_of(path.with_point_moved(1, {1, {7, 7}})) == std::vector<PathPoint>{a, {1, {7, 7}}, c});
    CHECK(points_of(path.with_point_moved(0, {5, {0, 0}})) == std::vector<PathPoint>{b, c, {5, {0, 0}}});
    CHECK_THROWS_AS(path.with_point_moved(1, {2, {0, 0}}), InputError);
    CHECK(points_of(*path.without_point(1)) == std::vector<PathPoint>{a, c});
    CHECK_FALSE(path_with({a}).without_point(0));
}

TEST_CASE("a simplified path has some of the points, both ends, and is within the tolerance at any time") {
    for (unsigned seed = 0; seed < trials(40); ++seed) {
        CAPTURE(seed);
        std::mt19937 random(seed);
        const DomainPath path = random_path(random, 1 + seed * 5);
        for (const double tolerance : {0.0, 0.01, 0.1, 1e9}) {
            CAPTURE(tolerance);
            const DomainPath simple = simplified(path, tolerance);
            CHECK(std::ranges::includes(path.points(), simple.points(), {}, &PathPoint::time,
                                        &PathPoint::time));
            for (const PathPoint& point : simple.points()) CHECK(path.at(point.time) == point.at);
            CHECK(simple.points().front() == path.points().front());
            CHECK(simple.points().back() == path.points().back());
            CHECK(largest_distance(simple, path) <= tolerance * (1 + 1e-12) + 1e-15);
            CHECK(simplified(simple, tolerance).points().size() <= simple.points().size());
        }
        CHECK(simplified(path, 1e9).points().size() == std::min<std::size_t>(path.points().size(), 2));
    }
}

TEST_CASE("a steady drag of 60 points per second becomes its two ends, and a rest on the way stays") {
    std::vector<PathPoint> steady;
    for (int i = 0; i <= 600; ++i) steady.push_back({i / 60.0, {i / 600.0, 0.5 - i / 300.0}});
    CHECK(simplified(path_with(steady), 1e-9).points().size() == 2);

    // Along the same line, but resting in the middle for a second.
    std::vector<PathPoint> resting;
    for (int i = 0; i <= 180; ++i) resting.push_back({i / 60.0, {std::clamp(i, 60, 120) / 60.0, 0}});
    const DomainPath simple = simplified(path_with(resting), 1e-9);
    CHECK(simple.points().size() == 4);
    CHECK(simple.at(1.5) == glm::dvec2(1.5, 0));
}

TEST_CASE("a tolerance or a smoothing below 0, or none, is an error") {
    const DomainPath path({{0, {0, 0}}, {1, {1, 1}}});
    for (const double number : {-0.1, not_a_time}) {
        CHECK_THROWS_AS(simplified(path, number), InputError);
        CHECK_THROWS_AS(smoothed(path, number), InputError);
    }
}

TEST_CASE("smoothing keeps the times, the first and the last point, and a straight even motion") {
    for (unsigned seed = 0; seed < trials(20); ++seed) {
        CAPTURE(seed);
        std::mt19937 random(seed);
        const DomainPath path = random_path(random, 1 + seed * 3);
        for (const double seconds : {1e-300, 1e-6, 0.05, 0.5, 100.0, infinity}) {
            CAPTURE(seconds);
            const DomainPath smooth = smoothed(path, seconds);
            CHECK(std::ranges::equal(smooth.points(), path.points(), {}, &PathPoint::time, &PathPoint::time));
            CHECK(smooth.points().front() == path.points().front());
            CHECK(smooth.points().back() == path.points().back());
            const DomainPath line = simplified(path, infinity);
            std::vector<PathPoint> even = points_of(path);
            for (PathPoint& point : even) point.at = line.at(point.time);
            CHECK(largest_distance(smoothed(path_with(even), seconds), line) < 1e-14);
        }
        CHECK(smoothed(path, 0) == path);
    }
}

TEST_CASE("smoothing over no time changes nothing, and over a long time leaves the straight motion") {
    std::mt19937 random(1);
    const DomainPath path = random_path(random, 40);
    CHECK(largest_distance(smoothed(path, 1e-9), path) < 1e-8);
    CHECK(largest_distance(smoothed(path, 1e9), simplified(path, infinity)) < 1e-8);
}

TEST_CASE("smoothing agrees with the sum over small steps that defines it") {
    for (unsigned seed = 0; seed < trials(8); ++seed) {
        CAPTURE(seed);
        std::mt19937 random(seed);
        const DomainPath path = random_path(random, 6);
        for (const double seconds : {0.03, 0.1, 0.4}) {
            CAPTURE(seconds);
            const DomainPath smooth = smoothed(path, seconds);
            const double sigma = std::min(seconds, 2 * (path.end() - path.begin()));
            for (const PathPoint& point : smooth.points())
                CHECK(glm::distance(point.at, smoothed_literally(path, sigma, point.time)) < 1e-5);
        }
    }
}

TEST_CASE("smoothing of dense points agrees with the sum over small steps, too") {
    for (unsigned seed = 0; seed < trials(4); ++seed) {
        CAPTURE(seed);
        std::mt19937 random(seed);
        const DomainPath path = random_path(random, 3000);
        const double sigma = (path.end() - path.begin()) / 50;
        const DomainPath smooth = smoothed(path, sigma);
        for (std::size_t i = 1; i < 3000; i += 331) {
            const PathPoint& point = smooth.points()[i];
            // The small steps pass over corners of the path, so the sum is off by 1e-5 itself.
            CHECK(glm::distance(point.at, smoothed_literally(path, sigma, point.time)) < 3e-5);
        }
    }
}

TEST_CASE("a sine between the ends is damped as the Gaussian's transform says") {
    constexpr int count = 2000;
    constexpr double duration = 4;
    std::vector<PathPoint> points;
    for (int i = 0; i <= count; ++i) {
        const double time = duration * i / count;
        points.push_back({10 + time, {time, std::sin(3 * std::numbers::pi * time / duration)}});
    }
    points.back().at.y = 0;
    constexpr double sigma = 0.2;
    const double frequency = 3 * std::numbers::pi / duration;
    const double damping = std::exp(-0.5 * frequency * frequency * sigma * sigma);
    const DomainPath path(points);
    const DomainPath smooth = smoothed(path, sigma);
    for (std::size_t i = 0; i < points.size(); ++i) {
        CHECK(smooth.points()[i].at.x == doctest::Approx(points[i].at.x));
        CHECK(std::abs(smooth.points()[i].at.y - damping * points[i].at.y) < 1e-5);
    }
}
