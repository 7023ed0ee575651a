// The property of matching, on a small sample; bench_generated_pairs measures many more pairs.
#include "fit/generated_pairs.h"

#include <cstdint>

#include <doctest/doctest.h>

using namespace interleaf;

TEST_CASE("matching brings meshes of generated bodies near their known correspondence, and flips nothing") {
    constexpr std::uint64_t count = 8;
    int exact = 0;
    double before = 0;
    double after = 0;
    for (std::uint64_t seed = 1; seed <= count; ++seed) {
        CAPTURE(seed);
        const testing::PairFigures figures = testing::figures_of(testing::generated_pair(seed, 3));
        CHECK(figures.is_one_to_one);
        CHECK(figures.mean_error < 0.025);
        before += figures.unmatched;
        after += figures.mean_error;
        MESSAGE("mean error " << 100 * figures.unmatched << " % before, " << 100 * figures.mean_error
                              << " % after");
        exact += figures.mean_error <= 0.02 ? 1 : 0;
    }
    CHECK(exact >= 6);
    CHECK(after < 0.4 * before);
}

TEST_CASE("a round body that keeps its shapes under a wrong map is matched, too") {
    constexpr std::uint64_t seed = 131;  // its bumps are low
    const testing::PairFigures figures = testing::figures_of(testing::generated_pair(seed, 5));
    CHECK(figures.unmatched > 0.05);
    CHECK(figures.is_matched);
    CHECK(figures.is_one_to_one);
    CHECK(figures.mean_error < 0.02);
}
