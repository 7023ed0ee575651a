#include "app/importing/point_motion.h"

#include <cmath>
#include <vector>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "hierarchy/adaptive_mesh.h"

using namespace interleaf;

namespace {

/// A sphere of radius 1, bisected \p rounds times, about \p center, turned by \p turn radians about z.
Hierarchy ball(int rounds, const glm::vec3& center, float turn) {
    const std::vector<glm::vec3> corners = {{1, 0, 0},  {-1, 0, 0}, {0, 1, 0},
                                            {0, -1, 0}, {0, 0, 1},  {0, 0, -1}};
    const RootComplex roots(
        6, {{4, 0, 2}, {4, 2, 1}, {4, 1, 3}, {4, 3, 0}, {5, 2, 0}, {5, 1, 2}, {5, 3, 1}, {5, 0, 3}});
    AdaptiveMesh mesh(roots, corners);
    for (int round = 0; round < rounds; ++round) {
        std::vector<Index> all;
        for (Index leaf = 0; leaf < mesh.leaf_bound(); ++leaf) all.push_back(leaf);
        mesh.refine(all);
    }
    Hierarchy key = mesh.freeze();
    for (glm::vec3& p : key.positions) {
        p = glm::normalize(p);
        p = center + glm::vec3(std::cos(turn) * p.x - std::sin(turn) * p.y,
                               std::sin(turn) * p.x + std::cos(turn) * p.y, p.z);
    }
    return key;
}

}  // namespace

TEST_CASE("points of a sphere that moves go twice as far as its surface, and of one that turns slide alone") {
    const Hierarchy here = ball(10, {}, 0);
    const double diagonal = 2 * std::sqrt(3.0);
    const PointMotion moved = motion_of_points(here, ball(10, {0, 0, 0.1F}, 0));
    CHECK(moved.points * diagonal == doctest::Approx(0.1).epsilon(0.01));
    CHECK(moved.surface * diagonal == doctest::Approx(0.05).epsilon(0.05));
    const PointMotion turned = motion_of_points(here, ball(9, {}, 0.1F));
    CHECK(turned.points * diagonal > 0.05);
    CHECK(turned.surface * diagonal < 0.005);
    const PointMotion none = motion_of_points(here, here);
    CHECK(none.points == 0);
    CHECK(none.surface < 1e-7);
}
