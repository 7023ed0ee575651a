// Tests of picking: what a ray hits.
#include "render/pick.h"

#include <random>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include "render/camera.h"
#include "render/test_surfaces.h"

using namespace interleaf;

namespace {

glm::vec3 point_of(const Hit& hit, const std::vector<Triangle>& triangles,
                   const std::vector<glm::vec3>& positions) {
    const auto& [a, b, c] = triangles[hit.triangle];
    return hit.barycentric.x * positions[a] + hit.barycentric.y * positions[b] +
           hit.barycentric.z * positions[c];
}

/// The first of all triangles that the ray hits, each found by solving its three equations.
std::optional<std::size_t> literal_hit(const std::vector<Triangle>& triangles,
                                       const std::vector<glm::vec3>& positions, const Ray& ray) {
    std::optional<std::size_t> first;
    double nearest = 1;
    for (std::size_t t = 0; t < triangles.size(); ++t) {
        const glm::dvec3 a(positions[triangles[t][0]]), b(positions[triangles[t][1]]),
            c(positions[triangles[t][2]]);
        const glm::dmat3 equations(b - a, c - a, glm::dvec3(ray.from) - glm::dvec3(ray.to));
        const glm::dvec3 solution = glm::inverse(equations) * (glm::dvec3(ray.from) - a);
        const bool inside = solution.x >= 0 && solution.y >= 0 && solution.x + solution.y <= 1;
        if (!inside || !(solution.z >= 0 && solution.z <= nearest)) continue;
        first = t;
        nearest = solution.z;
    }
    return first;
}

}  // namespace

TEST_CASE("the hit is the first of all triangles, and its point lies on the ray") {
    constexpr unsigned seed = 4;
    CAPTURE(seed);
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> place(-1, 1);
    const auto point = [&] {
        const float x = place(random), y = place(random), z = place(random);
        return glm::vec3(x, y, z);
    };
    int hits = 0;
    for (int round = 0; round < 3000; ++round) {
        std::vector<glm::vec3> positions;
        std::vector<Triangle> triangles;
        for (Index t = 0; t < 8; ++t) {
            triangles.push_back({3 * t, 3 * t + 1, 3 * t + 2});
            for (int corner = 0; corner < 3; ++corner) positions.push_back(point());
        }
        const Ray ray{2.0F * point(), 2.0F * point()};
        const std::optional<Hit> hit = first_hit(triangles, positions, ray);
        const std::optional<std::size_t> expected = literal_hit(triangles, positions, ray);
        REQUIRE(hit.has_value() == expected.has_value());
        if (!hit) continue;
        ++hits;
        REQUIRE(hit->triangle == *expected);
        const glm::vec3 at = point_of(*hit, triangles, positions);
        const glm::vec3 along = glm::normalize(ray.to - ray.from);
        REQUIRE(glm::length(glm::cross(at - ray.from, along)) < 1e-4F);
    }
    CHECK(hits > 500);
    CHECK(hits < 2900);
}

TEST_CASE("no ray slips between triangles: rays through vertices and edges of a sphere hit its near side") {
    const TestSurface sphere = surface_of_shapes({"sphere"}, 2000);
    const Buffer<glm::vec3>& positions = sphere.mesh.positions[0];
    for (const auto& [a, b, c] : sphere.mesh.triangles)
        for (const glm::vec3 target : {positions[a], (positions[a] + positions[b]) / 2.0F}) {
            const auto hit = first_hit(sphere.mesh.triangles, positions, {3.0F * target, -target});
            REQUIRE(hit);
            const auto& [i, j, k] = sphere.mesh.triangles[hit->triangle];
            const glm::vec3 at = hit->barycentric.x * positions[i] + hit->barycentric.y * positions[j] +
                                 hit->barycentric.z * positions[k];
            REQUIRE(glm::distance(at, target) < 1e-4F);
        }
}

TEST_CASE("a ray hits nothing beside a surface, beyond its ends, and in triangles of no area") {
    const std::vector<glm::vec3> positions{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {2, 0, 0}};
    const std::vector<Triangle> triangle{{0, 1, 2}};
    const glm::vec3 inside(0.25F, 0.25F, 0);
    const glm::vec3 up(0, 0, 1);
    CHECK(first_hit(triangle, positions, {inside + up, inside - up}));
    CHECK(first_hit(triangle, positions, {inside - up, inside + up}));
    CHECK_FALSE(first_hit(triangle, positions, {inside + up, inside + 0.1F * up}));
    CHECK_FALSE(first_hit(triangle, positions, {inside - 0.1F * up, inside - up}));
    CHECK_FALSE(first_hit(triangle, positions, {up, glm::vec3(1.2F, 1.2F, -1)}));
    CHECK_FALSE(first_hit(std::vector<Triangle>{{0, 1, 3}, {0, 0, 0}}, positions,
                          {glm::vec3(0.5F, 0, 1), glm::vec3(0.5F, 0, -1)}));
    CHECK_FALSE(first_hit({}, positions, {up, -up}));
}
