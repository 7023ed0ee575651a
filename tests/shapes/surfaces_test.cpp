#include "shapes/surfaces.h"

#include <array>
#include <cmath>
#include <random>
#include <vector>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "shapes/icosahedron.h"

using namespace interleaf;

namespace {

std::vector<glm::dvec3> random_directions(unsigned seed, std::size_t count) {
    std::mt19937 random(seed);
    std::normal_distribution<double> coordinate;
    std::vector<glm::dvec3> directions;
    for (std::size_t i = 0; i < count; ++i) {
        directions.push_back(
            glm::normalize(glm::dvec3(coordinate(random), coordinate(random), coordinate(random))));
    }
    return directions;
}

/// The literal formula of the bone, for w > 0.
glm::dvec3 literal_bone(const glm::dvec3& u) {
    const auto sigma = [](double t) { return 1 / (1 + std::exp(-14 * (std::abs(t) - 0.62))); };
    const double t = u.x;
    const double w = std::sqrt(1 - t * t);
    const double c = u.y / w;
    const double s = u.z / w;
    const double g = (sigma(t) - sigma(0)) / (1 - sigma(0));
    const double radius = std::sqrt(1 - std::pow(t, 6)) * (0.17 + 0.17 * g);
    const double sign = t < 0 ? -1 : 1;
    return {1.25 * t + sign * g * (0.256 * w * c * c - 0.17 * std::exp(-14 * c * c * w * w)),
            radius * (1 + 0.75 * g) * c, radius * s};
}

}  // namespace

TEST_CASE("the cushion satisfies its equation, on the ray and within the square") {
    const unsigned seed = 1;
    CAPTURE(seed);
    for (const glm::dvec3& u : random_directions(seed, 1000)) {
        const glm::dvec3 p = cushion_surface(u);
        CHECK(glm::length(glm::cross(p, u)) < 1e-15);
        CHECK(glm::dot(p, u) > 0);
        CHECK(std::abs(p.x) <= 1);
        CHECK(std::abs(p.y) <= 1);
        CHECK(std::abs(p.z * p.z - 0.55 * 0.55 * (1 - p.x * p.x) * (1 - p.y * p.y)) < 1e-14);
    }
    CHECK(cushion_surface({0, 0, 1}).z == doctest::Approx(0.55));
    CHECK(cushion_surface({1, 0, 0}).x == doctest::Approx(1));
    const double diagonal = std::sqrt(0.5);
    CHECK(cushion_surface({diagonal, diagonal, 0}).x == doctest::Approx(1));
}

TEST_CASE("the cushion of other constants satisfies its equation") {
    const unsigned seed = 4;
    CAPTURE(seed);
    for (const std::array constants : {std::array{0.1, 0.5}, std::array{1.0, 2.0}, std::array{0.3, 1.4}})
        for (const glm::dvec3& u : random_directions(seed, 300)) {
            const glm::dvec3 p = cushion_surface(u, constants);
            const double x = p.x / constants[1];
            CHECK(glm::length(glm::cross(p, u)) < 1e-15);
            CHECK(std::abs(x) <= 1 + 1e-15);
            CHECK(std::abs(p.z * p.z - constants[0] * constants[0] * (1 - x * x) * (1 - p.y * p.y)) < 1e-14);
        }
}

TEST_CASE("the star's arms point towards the vertices of the icosahedron") {
    for (const glm::dvec3 corner : icosahedron().positions) {
        const glm::dvec3 tip = glm::normalize(corner);
        const double radius = glm::length(star_surface(tip));
        CHECK(radius ==
              doctest::Approx(0.62 + 0.95 * (1 + 5 * std::exp(22 * (1 / std::sqrt(5.0) - 1)))).epsilon(1e-9));
        const unsigned seed = 2;
        CAPTURE(seed);
        for (const glm::dvec3& offset : random_directions(seed, 50)) {
            CHECK(glm::length(star_surface(glm::normalize(tip + 0.01 * offset))) < radius);
        }
    }
}

TEST_CASE("the star's radius is the sum over all twelve arms") {
    const unsigned seed = 3;
    CAPTURE(seed);
    for (const glm::dvec3& u : random_directions(seed, 1000)) {
        double radius = 0.62;
        for (const glm::dvec3 corner : icosahedron().positions) {
            radius += 0.95 * std::exp(22 * (glm::dot(u, glm::normalize(corner)) - 1));
        }
        CHECK(glm::distance(star_surface(u), radius * u) < 1e-6);
    }
}

TEST_CASE("the bone agrees with its literal formula, and is continuous at its poles") {
    const unsigned seed = 4;
    CAPTURE(seed);
    for (const glm::dvec3& u : random_directions(seed, 1000)) {
        CHECK(glm::distance(bone_surface(u), literal_bone(u)) < 1e-12);
    }
    for (const double side : {-1.0, 1.0}) {
        const glm::dvec3 pole = bone_surface({side, 0, 0});
        CHECK(pole.x == doctest::Approx(side * (1.25 - 0.17)).epsilon(1e-3));
        CHECK(pole.y == 0);
        CHECK(pole.z == 0);
        CHECK(glm::distance(bone_surface(glm::normalize(glm::dvec3(side, 1e-9, 1e-9))), pole) < 1e-8);
    }
    CHECK(glm::distance(bone_surface({-0.0, 0.6, 0.8}), bone_surface({0.0, 0.6, 0.8})) < 1e-15);
}
