// Tests of sparse weights.
#include "family/weights.h"

#include <doctest/doctest.h>

using namespace interleaf;

TEST_CASE("sorted weights have ascending keys, each once, with values added") {
    CHECK(sorted_weights({{3, 0.5}, {1, 0.25}, {3, 0.25}}) == Weights{{1, 0.25}, {3, 0.75}});
    CHECK(sorted_weights({}).empty());
}

TEST_CASE("a key of weight 0 stays active") {
    const Weights weights = sorted_weights({{2, 1}, {0, 0}});
    CHECK(active_keys(weights) == std::vector<std::size_t>{0, 2});
    CHECK(weight_values(weights) == std::vector<float>{0, 1});
}

TEST_CASE("weights are used as given, negative or above 1") {
    CHECK(weight_values({{0, -0.5}, {1, 2.5}}) == std::vector<float>{-0.5F, 2.5F});
}
