// Tests of the curves of weights: they go through the weights, and end where a key becomes inactive.
#include "ui/timeline/weight_curves.h"

#include <algorithm>

#include <doctest/doctest.h>

using namespace interleaf;

namespace {

std::vector<WeightCurve> curves_of(const Timeline& timeline, TimeRange visible, std::size_t samples) {
    Family family;
    family.timeline = timeline;
    return weight_curves(family, TimeSource::keys, visible, samples);
}

}  // namespace

TEST_CASE("every point of a curve is a weight of the timeline, and times ascend") {
    for (const Basis basis : bases()) {
        CAPTURE(name_of(basis));
        const Timeline timeline({{0, 0}, {1, 1}, {2, 2}, {4, 0}, {5, 3}}, {.basis = basis});
        for (const WeightCurve& curve : curves_of(timeline, {0.5, 4.5}, 100)) {
            REQUIRE(curve.points.size() >= 2);
            CHECK(std::ranges::is_sorted(curve.points, {}, &WeightCurve::Point::time));
            for (const auto& [time, weight] : curve.points) {
                CHECK(time >= 0.5);
                CHECK(time <= 4.5);
                const Weights weights = timeline.at(time);
                const auto found = std::ranges::find(weights, curve.key, &Weight::key);
                if (found != weights.end()) CHECK(weight == found->value);
            }
        }
    }
}

TEST_CASE("a linear key rises from 0 at the key before to 1, and falls to 0 at the key after") {
    const Timeline timeline({{0, 0}, {1, 1}, {3, 2}});
    const auto curves = curves_of(timeline, {0, 3}, 10);
    const auto curve = std::ranges::find(curves, std::size_t{1}, &WeightCurve::key);
    REQUIRE(curve != curves.end());
    CHECK(curve->points.front().time == 0);
    CHECK(curve->points.front().weight == 0);
    CHECK(std::ranges::max(curve->points, {}, &WeightCurve::Point::weight).time == 1);
    const auto first = std::ranges::find(curves, std::size_t{0}, &WeightCurve::key);
    CHECK(first->points.back().time == 1);
    CHECK(first->points.back().weight == 0);
}

TEST_CASE("a held key has a curve of its own from its time to the next, at weight 1") {
    const Timeline timeline({{0, 0}, {1, 1}, {3, 0}, {4, 2}}, {.basis = Basis::hold});
    const auto curves = curves_of(timeline, {0, 4}, 4);
    CHECK(std::ranges::count(curves, std::size_t{0}, &WeightCurve::key) == 2);
    CHECK(curves[0].points.back().time == 1);
    for (const WeightCurve& curve : curves)
        for (const WeightCurve::Point& point : curve.points) CHECK(point.weight == 1);
}

TEST_CASE("along a path, the curves are the weights of its points") {
    Family family;
    family.domain.emplace(std::vector<DomainVertex>{{{0, 0}, 4}, {{1, 0}, 5}, {{0, 1}, 6}},
                          std::vector<Triangle>{{0, 1, 2}});
    family.path.emplace(std::vector<PathPoint>{{0, {0, 0}}, {1, {1, 0}}, {3, {0, 1}}});
    const auto curves = weight_curves(family, TimeSource::path, {0, 3}, 60);
    REQUIRE(curves.size() == 3);
    const auto curve = std::ranges::find(curves, std::size_t{5}, &WeightCurve::key);
    REQUIRE(curve != curves.end());
    CHECK(std::ranges::max(curve->points, {}, &WeightCurve::Point::weight).time == 1);
    CHECK(curve->points.back().weight == 0);
}
