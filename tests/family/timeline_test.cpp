// Tests of the timeline's linear basis (paper, equation (2)).
#include "family/timeline.h"

#include <cmath>
#include <limits>

#include "numbers.h"
#include <doctest/doctest.h>

#include "hierarchy/error.h"

using namespace interleaf;

namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

}  // namespace

TEST_CASE("a timeline blends the keys before and after a time") {
    const Timeline timeline({{1, 4}, {3, 2}, {7, 0}});
    CHECK(timeline.begin() == 1);
    CHECK(timeline.end() == 7);
    // Between keys; the weights are sorted by key, not by time.
    CHECK(timeline.at(1.5) == Weights{{2, 0.25}, {4, 0.75}});
    CHECK(timeline.at(6) == Weights{{0, 0.75}, {2, 0.25}});
}

TEST_CASE(
    "at a key's own time it has weight 1, and the other key of the interval that begins there stays active") {
    const Timeline timeline({{1, 4}, {3, 2}, {7, 0}});
    CHECK(timeline.at(1) == Weights{{2, 0}, {4, 1}});
    CHECK(timeline.at(3) == Weights{{0, 0}, {2, 1}});
    CHECK(timeline.at(std::nextafter(3, 0)).back().key == 4);
    CHECK(timeline.at(7) == Weights{{0, 1}, {2, 0}});
}

TEST_CASE("a time outside is clamped to the nearest end") {
    const Timeline timeline({{1, 4}, {3, 2}, {7, 0}});
    CHECK(timeline.at(-10) == timeline.at(1));
    CHECK(timeline.at(8) == timeline.at(7));
    CHECK(timeline.at(infinity) == timeline.at(7));
    CHECK(timeline.at(-infinity) == timeline.at(1));
}

TEST_CASE("one key, or the same key twice in a row, has weight 1") {
    CHECK(Timeline({{5, 3}}).at(0) == Weights{{3, 1}});
    CHECK(Timeline({{0, 3}, {2, 3}, {4, 1}}).at(1) == Weights{{3, 1}});
    CHECK(Timeline({{0, 3}, {2, 3}, {4, 1}}).at(3) == Weights{{1, 0.5}, {3, 0.5}});
}

TEST_CASE("the weights of a timeline are not negative and sum to 1") {
    const Timeline timeline({{-1, 0}, {0.1, 1}, {0.3, 2}, {7.7, 3}});
    for (double time = -1.5; time < 8; time += 0.01) {
        double sum = 0;
        for (const Weight& weight : timeline.at(time)) {
            CHECK(weight.value >= 0);
            sum += weight.value;
        }
        CHECK(sum == doctest::Approx(1).epsilon(1e-15));
    }
}

TEST_CASE("a timeline without keys, or with times that do not ascend, is rejected") {
    CHECK_THROWS_WITH_AS(Timeline({}), doctest::Contains("no key"), InputError);
    CHECK_THROWS_WITH_AS(Timeline({{1, 0}, {1, 1}}), doctest::Contains("key 1 is at time 1"), InputError);
    CHECK_THROWS_WITH_AS(Timeline({{0, 0}, {2, 1}, {1, 2}}), doctest::Contains("key 2 is at time 1"),
                         InputError);
    CHECK_THROWS_WITH_AS(Timeline({{not_a_number, 0}}), doctest::Contains("not a finite number"), InputError);
    CHECK_THROWS_WITH_AS(Timeline({{0, 0}, {infinity, 1}}), doctest::Contains("key 1"), InputError);
    CHECK_THROWS_WITH_AS(Timeline({{-1e308, 0}, {1e308, 1}}), doctest::Contains("too far apart"), InputError);
}

TEST_CASE("a time that is not a number is rejected") {
    CHECK_THROWS_AS(Timeline({{0, 0}, {1, 1}}).at(not_a_number), InputError);
}

TEST_CASE("every edit of a timeline keeps its unit") {
    const Timeline steps({{0, 0}, {1, 1}, {2, 2}}, {}, TimeUnit::steps);
    CHECK(steps.with_entry({3, 1}).unit() == TimeUnit::steps);
    CHECK(steps.with_time(1, 1.5).unit() == TimeUnit::steps);
    CHECK(steps.without_entry(0)->unit() == TimeUnit::steps);
    CHECK(steps.without_key(1)->unit() == TimeUnit::steps);
    CHECK(steps.with_interpolation({.basis = Basis::hold}).unit() == TimeUnit::steps);
    CHECK(steps.with_keys_renumbered([](std::size_t key) { return key; }) == steps);
    CHECK(steps.with_unit(TimeUnit::seconds) != steps);
    for (const TimeUnit unit : {TimeUnit::seconds, TimeUnit::steps})
        CHECK(time_unit_named(name_of(unit)) == unit);
    CHECK_FALSE(time_unit_named("step"));
}
