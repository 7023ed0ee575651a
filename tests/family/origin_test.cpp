#include "family/origin.h"

#include <limits>
#include <random>

#include <doctest/doctest.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

using namespace interleaf;

namespace {

/// A triangle of size 1 at \p place, and a vertex that it does not use.
std::vector<glm::dvec3> triangle_at(const glm::dvec3& place) {
    return {place, place + glm::dvec3(1, 0, 0), place + glm::dvec3(0, 1, 0), glm::dvec3(-1e30)};
}

glm::dvec3 origin_of_triangle_at(const glm::dvec3& place) {
    return origin_for(triangle_at(place), std::vector<Triangle>{{0, 1, 2}});
}

}  // namespace

TEST_CASE("a mesh near 0 gets the origin 0") {
    CHECK(origin_of_triangle_at({0, 0, 0}) == glm::dvec3(0));
    CHECK(origin_of_triangle_at({100, 0, 0}) == glm::dvec3(0));
    CHECK(origin_of_triangle_at({0, 0, -140}) == glm::dvec3(0));
    CHECK(origin_for({}, {}) == glm::dvec3(0));
}

TEST_CASE("a mesh more than 100 diagonals from 0 gets its center in whole numbers as origin") {
    CHECK(origin_of_triangle_at({500'000.2, 5'400'000.7, 300}) == glm::dvec3(500'001, 5'400'001, 300));
    CHECK(origin_of_triangle_at({0, 0, -142}) == glm::dvec3(1, 1, -142));
    for (unsigned seed = 0; seed < 1000; ++seed) {
        CAPTURE(seed);
        std::mt19937 random(seed);
        std::uniform_real_distribution<double> place(-1e7, 1e7);
        const std::vector<glm::dvec3> positions = triangle_at({place(random), place(random), place(random)});
        const glm::dvec3 origin = origin_for(positions, std::vector<Triangle>{{0, 1, 2}});
        REQUIRE(origin == glm::round(origin));
        for (std::size_t corner = 0; corner < 3; ++corner)
            REQUIRE(glm::distance(positions[corner], origin) < 2.5);
    }
}

TEST_CASE("a mesh so small that whole numbers would not bring it nearer to 0 gets the origin 0") {
    std::vector<glm::dvec3> positions = triangle_at({0, 0, 0});
    for (glm::dvec3& position : positions) position = 1e-6 * position + glm::dvec3(0.4, 0, 0);
    CHECK(origin_for(positions, std::vector<Triangle>{{0, 1, 2}}) == glm::dvec3(0));
}

TEST_CASE("a mesh at the limits of floats gets a finite origin") {
    constexpr double most = std::numeric_limits<float>::max();
    const glm::dvec3 origin = origin_of_triangle_at({most, most, most});
    CHECK(origin == glm::dvec3(most));
    CHECK(origin_for(std::vector<glm::dvec3>{{most, 0, 0}, {-most, 0, 0}, {0, most, 0}},
                     std::vector<Triangle>{{0, 1, 2}}) == glm::dvec3(0));
}

TEST_CASE("keys move from one origin to another, and a sentence names an origin") {
    std::vector<Key> keys{
        {"k", unrefined(RootComplex(3, {{0, 1, 2}}), {{0.5F, 0, 0}, {1, 0, 0}, {0, 1, 0}})}};
    move_origin(keys, {500'000, 5'400'000, 0}, {500'001, 5'400'000, -3});
    CHECK(keys[0].hierarchy->positions[0] == glm::vec3(-0.5F, 0, 3));
    CHECK(origin_sentence({500'000, -5'400'000, 0}) ==
          "Far from 0: (500000, -5400000, 0) was subtracted from all positions.");
}
