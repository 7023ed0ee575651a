// Tests of the edits of weights.
#include "family/weight_edits.h"

#include <doctest/doctest.h>

using namespace interleaf;

TEST_CASE("a weight is set where its key is, or inserted in the order of the keys") {
    const Weights weights{{1, 0.5}, {4, 0.5}};
    CHECK(with_weight(weights, 4, -2) == Weights{{1, 0.5}, {4, -2}});
    CHECK(with_weight(weights, 0, 1) == Weights{{0, 1}, {1, 0.5}, {4, 0.5}});
    CHECK(with_weight(weights, 2, 0) == Weights{{1, 0.5}, {2, 0}, {4, 0.5}});
    CHECK(with_weight(weights, 9, 1) == Weights{{1, 0.5}, {4, 0.5}, {9, 1}});
}

TEST_CASE("a key is taken out unless it is the last one") {
    const Weights weights{{1, 0.5}, {4, 0.25}};
    CHECK(without_key(weights, 1) == Weights{{4, 0.25}});
    CHECK(without_key(weights, 2) == weights);
    CHECK(without_key({{4, 0.25}}, 4) == Weights{{4, 0.25}});
}

TEST_CASE("weights are divided by their sum, also a negative one, but not by 0") {
    CHECK(summed_to_one({{0, 1}, {1, 3}}) == Weights{{0, 0.25}, {1, 0.75}});
    CHECK(summed_to_one({{0, -1}, {2, -1}}) == Weights{{0, 0.5}, {2, 0.5}});
    CHECK(summed_to_one({{0, 2}, {1, -1}}) == Weights{{0, 2}, {1, -1}});
    CHECK_FALSE(summed_to_one({{0, 0}, {1, 0}}));
    CHECK_FALSE(summed_to_one({{0, 1}, {1, -1}}));
    CHECK_FALSE(summed_to_one({{0, 1}, {1, -1.0000000000001}}));
}
