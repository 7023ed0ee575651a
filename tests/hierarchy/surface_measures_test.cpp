#include "hierarchy/surface_measures.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "hierarchy/adaptive_mesh.h"
#include "hierarchy/measure.h"
#include "hierarchy/random_families.h"
#include "hierarchy/union_mesh.h"

using namespace interleaf;
using namespace interleaf::testing;

namespace {

/// The octahedron, bisected evenly, with its vertices on the sphere of \p radius.
UnionMesh sphere(float radius) {
    const std::vector<glm::vec3> corners = {{1, 0, 0},  {-1, 0, 0}, {0, 1, 0},
                                            {0, -1, 0}, {0, 0, 1},  {0, 0, -1}};
    AdaptiveMesh mesh(octahedron(), corners);
    for (int round = 0; round < 8; ++round) {
        std::vector<Index> all(mesh.leaf_count());
        for (Index leaf = 0; leaf < all.size(); ++leaf) all[leaf] = leaf;
        mesh.refine(all);
    }
    Hierarchy key = mesh.freeze();
    for (glm::vec3& position : key.positions) position = radius * glm::normalize(position);
    return unite(std::vector<const Hierarchy*>{&key});
}

}  // namespace

TEST_CASE("the smallest angle is that of the law of cosines, and 0 without area") {
    const std::vector<glm::vec3> positions = {
        {0, 0, 0}, {1, 0, 0}, {0, 2, 0}, {0.5F, std::sqrt(0.75F), 0}, {2, 0, 0}};
    const std::vector<Triangle> triangles = {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}, {0, 0, 1}};
    const std::vector<float> angles = smallest_angles(triangles, positions);
    REQUIRE(angles.size() == 4);
    CHECK(angles[0] == doctest::Approx(glm::degrees(std::atan(0.5))));
    CHECK(angles[1] == doctest::Approx(60));
    CHECK(angles[2] == 0);
    CHECK(angles[3] == 0);
}

TEST_CASE("the smallest of all smallest angles is that of measure()") {
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        const RandomFamily family = random_family(seed, 1);
        const UnionMesh mesh = unite(family.key_pointers());
        const std::vector<float> angles = smallest_angles(mesh.triangles, mesh.positions[0]);
        CHECK(*std::min_element(angles.begin(), angles.end()) ==
              doctest::Approx(measure(mesh.triangles, mesh.positions[0]).min_angle).epsilon(1e-4));
    }
}

TEST_CASE("the mean curvature of a sphere is the inverse of its radius, below 0 seen from inside") {
    UnionMesh mesh = sphere(2);
    REQUIRE(measure(mesh.triangles, mesh.positions[0]).volume > 0);
    for (const float curvature : mean_curvatures(mesh.triangles, mesh.positions[0]))
        CHECK(curvature == doctest::Approx(0.5).epsilon(0.002));
    for (Triangle& triangle : mesh.triangles) std::swap(triangle[1], triangle[2]);
    for (const float curvature : mean_curvatures(mesh.triangles, mesh.positions[0])) CHECK(curvature < 0);
}

TEST_CASE("a plane has no mean curvature, and a cylinder half its inverse radius, also at its ends") {
    constexpr unsigned columns = 40, rows = 10;
    std::vector<glm::vec3> flat, round;
    std::vector<Triangle> triangles;
    for (unsigned row = 0; row <= rows; ++row)
        for (unsigned column = 0; column <= columns; ++column) {
            const float angle = static_cast<float>(column) * 0.05F;
            flat.emplace_back(angle, static_cast<float>(row) * 0.1F, 0);
            round.emplace_back(3 * std::sin(angle), static_cast<float>(row) * 0.1F, 3 * std::cos(angle));
            if (row == rows || column == columns) continue;
            const Index a = row * (columns + 1) + column;
            triangles.push_back({a, a + 1, a + columns + 2});
            triangles.push_back({a, a + columns + 2, a + columns + 1});
        }
    for (const float curvature : mean_curvatures(triangles, flat)) CHECK(std::abs(curvature) < 1e-4F);
    const std::vector<float> curvatures = mean_curvatures(triangles, round);
    for (const float curvature : curvatures) CHECK(curvature == doctest::Approx(1.0 / 6).epsilon(0.002));
}

TEST_CASE("measures of triangles without area are finite") {
    const std::vector<glm::vec3> positions = {
        {0, 0, 0}, {1, 0, 0}, {1, 0, 0}, {0.5F, 0, 0}, {0.5F, 1e-20F, 0}};
    const std::vector<Triangle> triangles = {{0, 1, 2}, {0, 2, 3}, {0, 3, 4},
                                             {0, 4, 1}, {1, 4, 2}, {4, 3, 2}};
    for (const float value : mean_curvatures(triangles, positions)) CHECK(std::isfinite(value));
    for (const float value : smallest_angles(triangles, positions)) CHECK(std::isfinite(value));
}

TEST_CASE("distances whose squares are no floats are measured, too") {
    const std::vector<glm::vec3> before = {{0, 0, 0}, {0, 0, 0}, {-3e38F, 0, 0}};
    const std::vector<glm::vec3> after = {{3e30F, 4e30F, 0}, {3e-30F, 4e-30F, 0}, {3e38F, 0, 0}};
    const std::vector<float> lengths = distances(before, after);
    CHECK(lengths[0] == doctest::Approx(5e30));
    CHECK(lengths[1] * 1e30F == doctest::Approx(5));
    CHECK(std::isfinite(lengths[2]));
}
