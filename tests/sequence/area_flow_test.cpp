#include "sequence/area_flow.h"

#include <cmath>
#include <numbers>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "hierarchy/adaptive_mesh.h"

namespace interleaf {
namespace {

struct PlainMesh {
    std::vector<Triangle> triangles;
    std::vector<glm::dvec3> positions;
    Pinned is_pinned;
};

/// An octahedron whose faces are bisected \p rounds times, projected to the unit sphere.
PlainMesh bisected_sphere(int rounds) {
    const RootComplex roots(
        6, {{4, 0, 1}, {4, 1, 2}, {4, 2, 3}, {4, 3, 0}, {5, 1, 0}, {5, 2, 1}, {5, 3, 2}, {5, 0, 3}});
    std::vector<glm::dvec3> positions = {{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    std::vector<glm::vec3> corners(positions.begin(), positions.end());
    AdaptiveMesh mesh(roots, corners, [&](Index a, Index b, Index) {
        positions.push_back(glm::normalize(positions[a] + positions[b]));
        return glm::vec3(positions.back());
    });
    for (int i = 0; i < rounds; ++i) mesh.refine(mesh.preorder());
    PlainMesh plain{{}, positions, Pinned(positions.size())};
    for (const Index leaf : mesh.preorder()) plain.triangles.push_back(mesh.vertices(leaf));
    return plain;
}

TEST_CASE("the unit sphere has mean curvature 1, also where eight and four bisected triangles meet") {
    const PlainMesh sphere = bisected_sphere(9);
    for (const float curvature : mean_curvatures(sphere.triangles, sphere.is_pinned, sphere.positions))
        CHECK(curvature == doctest::Approx(1).epsilon(0.02));
}

TEST_CASE("normals of the unit sphere are its positions") {
    const PlainMesh sphere = bisected_sphere(9);
    const std::vector<glm::dvec3> normals = area_weighted_normals(sphere.triangles, sphere.positions);
    for (std::size_t v = 0; v < normals.size(); ++v)
        CHECK(glm::distance(normals[v], sphere.positions[v]) < 0.05);
}

TEST_CASE("a sphere stays a sphere and shrinks: its radius at time t is the square root of 1 - 4t") {
    PlainMesh sphere = bisected_sphere(8);
    constexpr int steps = 100;
    constexpr double time = 0.1;
    for (int i = 0; i < steps; ++i)
        step_to_smaller_area(sphere.triangles, sphere.is_pinned, time / steps, sphere.positions);
    for (const glm::dvec3& position : sphere.positions)
        CHECK(glm::length(position) == doctest::Approx(std::sqrt(1 - 4 * time)).epsilon(0.02));
}

TEST_CASE("a crumpled square with pinned sides becomes flat, and its pinned vertices stay") {
    constexpr Index side = 9;
    PlainMesh square;
    for (Index y = 0; y < side; ++y) {
        for (Index x = 0; x < side; ++x) {
            const bool is_boundary = x == 0 || y == 0 || x + 1 == side || y + 1 == side;
            square.is_pinned.push_back(is_boundary);
            square.positions.emplace_back(x, y, is_boundary ? 0 : std::sin(3.0 * x + 5.0 * y));
        }
    }
    for (Index y = 0; y + 1 < side; ++y) {
        for (Index x = 0; x + 1 < side; ++x) {
            const Index corner = y * side + x;
            square.triangles.push_back({corner + 1, corner + side + 1, corner});
            square.triangles.push_back({corner + side, corner, corner + side + 1});
        }
    }
    const std::vector<glm::dvec3> before = square.positions;
    for (int i = 0; i < 40; ++i)
        step_to_smaller_area(square.triangles, square.is_pinned, 5, square.positions);
    for (std::size_t v = 0; v < before.size(); ++v) {
        CHECK(std::abs(square.positions[v].z) < 1e-3);
        if (square.is_pinned[v]) CHECK(square.positions[v] == before[v]);
    }
}

TEST_CASE("places that no triangle uses stay as they are, and so does a surface of pinned vertices") {
    std::vector<glm::dvec3> positions = {{0, 0, 0}, {7, 7, 7}, {1, 0, 0}, {0, 1, 0}};
    const std::vector<glm::dvec3> before = positions;
    const std::vector<Triangle> triangles = {{0, 2, 3}};
    step_to_smaller_area(triangles, Pinned(4, true), 1, positions);
    CHECK(positions == before);
    CHECK(mean_curvatures(triangles, Pinned(4, true), positions) == std::vector<float>(4, 0.0F));
    CHECK(area_weighted_normals(triangles, positions)[1] == glm::dvec3(0));
}

}  // namespace
}  // namespace interleaf
