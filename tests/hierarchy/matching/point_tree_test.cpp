#include "hierarchy/matching/point_tree.h"

#include <algorithm>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "hierarchy/random_families.h"

using namespace interleaf;
using interleaf::testing::Random;

TEST_CASE("the tree returns the nearest remaining point until none remains") {
    for (std::uint64_t seed = 1; seed <= 200; ++seed) {
        CAPTURE(seed);
        Random random(seed);
        std::vector<glm::dvec3> points(1 + random.below(300));
        for (glm::dvec3& p : points) {
            p = random.point();
            if (seed % 3 == 0) p.x = 0;  // ties along an axis
        }
        PointTree tree(points);
        std::vector<bool> is_taken(points.size());
        for (std::size_t n = 0; n < points.size(); ++n) {
            const glm::dvec3 at = random.point();
            const std::size_t taken = tree.take_nearest(at);
            REQUIRE(taken < points.size());
            REQUIRE_FALSE(is_taken[taken]);
            for (std::size_t other = 0; other < points.size(); ++other)
                if (!is_taken[other])
                    REQUIRE(glm::distance(points[taken], at) <= glm::distance(points[other], at) + 1e-15);
            is_taken[taken] = true;
        }
    }
}

TEST_CASE("each of several points at one place is taken once") {
    const std::vector<glm::dvec3> points(5000);
    PointTree tree(points);
    std::vector<std::size_t> taken;
    for (std::size_t n = 0; n < points.size(); ++n) taken.push_back(tree.take_nearest({1, 1, 1}));
    std::sort(taken.begin(), taken.end());
    for (std::size_t n = 0; n < taken.size(); ++n) REQUIRE(taken[n] == n);
}
