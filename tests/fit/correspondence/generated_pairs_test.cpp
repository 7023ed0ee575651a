// The property of matching, on a small sample; bench_generated_pairs measures many more pairs.
#include "fit/generated_pairs.h"

#include <cstdint>

#include <doctest/doctest.h>

using namespace interleaf;

TEST_CASE(
    "matching finds the correspondence of generated bodies within 2 % of the diagonal, and flips nothing") {
    constexpr std::uint64_t count = 8;
    int exact = 0;
    for (std::uint64_t seed = 1; seed <= count; ++seed) {
        CAPTURE(seed);
        const testing::PairFigures figures = testing::figures_of(testing::generated_pair(seed, 3));
        CHECK(figures.is_one_to_one);
        CHECK(figures.mean_error <= figures.unmatched);
        CHECK(figures.unmatched > 0.02);
        MESSAGE("mean error " << 100 * figures.unmatched << " % before, " << 100 * figures.mean_error
                              << " % after");
        exact += figures.mean_error <= 0.02 ? 1 : 0;
    }
    CHECK(exact >= int(count) - 1);
}
