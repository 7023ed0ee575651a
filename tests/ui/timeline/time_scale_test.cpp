// Tests of the timeline's scale: zoom and pan stay within the timeline, and ticks are round.
#include "ui/timeline/time_scale.h"

#include <cmath>
#include <random>
#include <set>

#include <doctest/doctest.h>

using namespace interleaf;

TEST_CASE("a zoom keeps the time under the pointer, and all of the timeline limits it") {
    const TimeRange whole{0, 100};
    const TimeRange half = zoomed(whole, whole, 30, 0.5);
    CHECK(half.begin == doctest::Approx(15));
    CHECK(half.end == doctest::Approx(65));
    CHECK(zoomed(half, whole, 30, 2).begin == doctest::Approx(0));
    CHECK(zoomed(half, whole, 30, 1000) == whole);
    TimeRange visible = whole;
    for (int i = 0; i < 1000; ++i) visible = zoomed(visible, whole, 30, 0.8);
    CHECK(visible.begin <= 30);
    CHECK(visible.end >= 30);
    CHECK(visible.end - visible.begin == doctest::Approx(1e-4));
}

TEST_CASE("zooms and pans at random never leave the timeline") {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> part(0, 1);
    const TimeRange whole{-3, 17};
    TimeRange visible = whole;
    for (int i = 0; i < 2000; ++i) {
        const double at = visible.begin + part(random) * (visible.end - visible.begin);
        visible = random() % 2 == 0 ? zoomed(visible, whole, at, 0.3 + 1.6 * part(random))
                                    : panned(visible, whole, 10 * part(random) - 5);
        REQUIRE(visible.begin >= whole.begin);
        REQUIRE(visible.end <= whole.end);
        REQUIRE(visible.begin < visible.end);
    }
}

TEST_CASE("labels of the ruler are round, apart from each other, and each tick occurs once") {
    for (const TimeRange visible : {TimeRange{0, 10}, TimeRange{1.1, 1.2}, TimeRange{0, 299}}) {
        const TimeScale scale{visible, {0, 0, 800, 20}};
        std::set<double> times;
        float last = -1e9F;
        std::size_t labels = 0;
        for (const auto& [time, label] : time_ticks(scale, 70)) {
            CHECK(times.insert(time).second);
            CHECK(time >= visible.begin);
            CHECK(time <= visible.end);
            if (label.empty()) continue;
            ++labels;
            CHECK(label.size() < 8);
            CHECK(scale.pixel(time) - last >= 69);
            last = scale.pixel(time);
        }
        CHECK(labels >= 3);
        CHECK(times.size() > labels);
    }
}

TEST_CASE("a timeline of one key has a scale, too") {
    const TimeScale scale{{4, 4}, {10, 0, 100, 20}};
    CHECK(scale.pixel(4) == 10);
    CHECK(scale.time(50) == 4);
    CHECK(time_ticks(scale, 50).empty());
    CHECK(zoomed({4, 4}, {4, 4}, 4, 0.5) == TimeRange{4, 4});
    CHECK(panned({4, 4}, {4, 4}, 3) == TimeRange{4, 4});
}

TEST_CASE("the ruler of steps has whole steps, unless a single one fills it") {
    for (const double length : {1.5, 3.0, 20.0, 300.0}) {
        CAPTURE(length);
        const auto ticks = time_ticks({{2, 2 + length}, {0, 0, 1200, 20}}, 70, TimeUnit::steps);
        CHECK_FALSE(ticks.empty());
        for (const TimeTick& tick : ticks) CHECK(tick.time == doctest::Approx(std::round(tick.time)));
    }
    CHECK(time_ticks({{2.1, 2.9}, {0, 0, 1200, 20}}, 70, TimeUnit::steps).size() > 5);
}
