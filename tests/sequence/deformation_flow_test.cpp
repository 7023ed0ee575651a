#include "sequence/deformation_flow.h"

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

namespace interleaf {
namespace {

constexpr double period = 1.5;

/// The velocity as the papers print it.
glm::dvec3 printed_velocity(const glm::dvec3& p, double time) {
    const auto sine = [](double x) { return std::sin(std::numbers::pi * x); };
    const auto squared = [&](double x) { return sine(x) * sine(x); };
    return std::cos(std::numbers::pi * time / period) *
           glm::dvec3(2 * squared(p.x) * sine(2 * p.y) * sine(2 * p.z),
                      -sine(2 * p.x) * squared(p.y) * sine(2 * p.z),
                      -sine(2 * p.x) * sine(2 * p.y) * squared(p.z));
}

std::vector<glm::dvec3> random_directions(unsigned seed, int count) {
    std::mt19937 random(seed);
    std::normal_distribution<double> normal;
    std::vector<glm::dvec3> directions;
    for (int i = 0; i < count; ++i) {
        const double x = normal(random);
        const double y = normal(random);
        directions.push_back(glm::normalize(glm::dvec3(x, y, normal(random))));
    }
    return directions;
}

TEST_CASE("the velocity is the printed one, and has no divergence") {
    constexpr unsigned seed = 11;
    CAPTURE(seed);
    constexpr double h = 1e-5;
    for (const glm::dvec3& direction : random_directions(seed, 50)) {
        const glm::dvec3 p = 0.5 + 0.5 * direction;
        CHECK(glm::distance(deformation_velocity(p, 0.4, period), printed_velocity(p, 0.4)) < 1e-13);
        double divergence = 0;
        for (int axis = 0; axis < 3; ++axis) {
            glm::dvec3 step(0);
            step[axis] = h;
            divergence += (deformation_velocity(p + step, 0.4, period)[axis] -
                           deformation_velocity(p - step, 0.4, period)[axis]) /
                          (2 * h);
        }
        CHECK(std::abs(divergence) < 1e-8);
    }
}

TEST_CASE("a point moved at once is where the steps in time bring it, at any time and strength 1") {
    constexpr unsigned seed = 14;
    CAPTURE(seed);
    const std::vector<glm::dvec3> directions = random_directions(seed, 5);
    FlowingSphere sphere(period, 10);
    for (int step = 1; step <= 10; ++step) {
        sphere.advance();
        for (const glm::dvec3& direction : directions)
            CHECK(glm::distance(flowed_point(direction, 0.1 * step * period, 1, period),
                                sphere.at(direction)) < 1e-5);
    }
    CHECK(flowed_point({1, 0, 0}, 0.4, 0, period) == flow_ball_center + glm::dvec3(flow_ball_radius, 0, 0));
}

TEST_CASE("points move as with many small steps of the midpoint method") {
    constexpr unsigned seed = 12;
    CAPTURE(seed);
    const std::vector<glm::dvec3> directions = random_directions(seed, 5);
    FlowingSphere sphere(period, 10);
    for (int step = 0; step < 5; ++step) sphere.advance();
    for (const glm::dvec3& direction : directions) {
        glm::dvec3 position = flow_ball_center + flow_ball_radius * direction;
        constexpr int small_steps = 4000;
        constexpr double length = period / 2 / small_steps;
        for (int i = 0; i < small_steps; ++i) {
            const glm::dvec3 middle = position + length / 2 * printed_velocity(position, i * length);
            position += length * printed_velocity(middle, (i + 0.5) * length);
        }
        CHECK(glm::distance(sphere.at(direction), position) < 1e-5);
    }
}

TEST_CASE("a point that is requested late is where it would be if it had been requested early") {
    const glm::dvec3 direction = glm::normalize(glm::dvec3(1, -2, 3));
    FlowingSphere early(period, 7);
    FlowingSphere late(period, 7);
    early.at(direction);
    for (int step = 0; step < 4; ++step) {
        early.advance();
        early.at(direction);
        late.advance();
    }
    CHECK(early.at(direction) == late.at(direction));
}

TEST_CASE("at the period every point is where it was, whatever the number of steps") {
    constexpr unsigned seed = 13;
    CAPTURE(seed);
    for (const unsigned steps : {1U, 3U, 60U}) {
        CAPTURE(steps);
        FlowingSphere sphere(period, steps);
        for (unsigned step = 0; step < steps; ++step) sphere.advance();
        for (const glm::dvec3& direction : random_directions(seed, 20))
            CHECK(glm::distance(sphere.at(direction), flow_ball_center + flow_ball_radius * direction) <
                  1e-5);
    }
}

}  // namespace
}  // namespace interleaf
