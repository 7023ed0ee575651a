// Tests of the interpolation bases: each has a name, and weights that are the keys' own at their times.
#include "family/interpolation.h"

#include <cmath>
#include <set>

#include <doctest/doctest.h>

using namespace interleaf;

TEST_CASE("every basis is found by a name of its own") {
    std::set<std::string_view> names;
    for (const Interpolation each : interpolations()) {
        CHECK(names.insert(name_of(each)).second);
        CHECK(interpolation_named(name_of(each)) == each);
    }
    CHECK(names.contains("linear"));
    CHECK_FALSE(interpolation_named("Linear"));
    CHECK_FALSE(interpolation_named(""));
}

TEST_CASE("the weights of every basis are sparse, ascending and sum to 1") {
    const std::vector<TimelineKey> keys{{-1, 2}, {0.5, 0}, {2, 2}, {3, 1}, {7, 1}};
    for (const Interpolation each : interpolations()) {
        CAPTURE(name_of(each));
        for (std::size_t count = 1; count <= keys.size(); ++count)
            for (double part = 0; part <= 1; part += 1.0 / 64) {
                const auto first = std::span(keys).first(count);
                const double time = first.front().time + part * (first.back().time - first.front().time);
                const Weights weights = weights_at(each, first, time);
                REQUIRE_FALSE(weights.empty());
                double sum = 0;
                for (std::size_t i = 0; i < weights.size(); ++i) {
                    REQUIRE((i == 0 || weights[i - 1].key < weights[i].key));
                    sum += weights[i].value;
                }
                REQUIRE(sum == doctest::Approx(1));
            }
    }
}
