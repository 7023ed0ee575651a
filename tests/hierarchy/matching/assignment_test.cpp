#include "hierarchy/matching/assignment.h"

#include <algorithm>
#include <numeric>

#include "trials.h"
#include <doctest/doctest.h>

#include "hierarchy/random_families.h"

using namespace interleaf;
using interleaf::testing::Random;

TEST_CASE("an assignment is a permutation, and none of all permutations costs less") {
    for (std::uint64_t seed = 1; seed <= trials(500); ++seed) {
        CAPTURE(seed);
        Random random(seed);
        const std::size_t count = 1 + random.below(7);
        std::vector<double> cost(count * count);
        // Whole numbers cause ties, and negative numbers are allowed.
        for (double& c : cost)
            c = seed % 2 == 0 ? static_cast<double>(random.below(4)) - 2 : random.unit() * 100 - 50;
        const auto total = [&](const std::vector<std::size_t>& partners) {
            double sum = 0;
            for (std::size_t row = 0; row < count; ++row) sum += cost[row * count + partners[row]];
            return sum;
        };
        const std::vector<std::size_t> found = assignment(count, cost);
        std::vector<std::size_t> partners(count);
        std::iota(partners.begin(), partners.end(), std::size_t{0});
        REQUIRE(std::is_permutation(found.begin(), found.end(), partners.begin(), partners.end()));
        double least = total(partners);
        while (std::next_permutation(partners.begin(), partners.end()))
            least = std::min(least, total(partners));
        REQUIRE(total(found) == doctest::Approx(least));
    }
}
