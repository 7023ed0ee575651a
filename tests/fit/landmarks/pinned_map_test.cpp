// Maps bring landmarks to their targets to the last bit, and stay one to one.
#include "fit/landmarks/pinned_map.h"

#include <cstdint>
#include <random>
#include <string>
#include <utility>

#include "messages.h"
#include "thrown_errors.h"
#include "trials.h"
#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "fit/landmarks/sphere_flow.h"
#include "fit/sphere_map/orientation.h"
#include "fit/sphere_map/spherical_map.h"
#include "fit/star_shapes.h"

using namespace interleaf;
using namespace interleaf::testing;

namespace {

/// A ball with bumps in random directions.
MappedMesh random_body(std::mt19937& random, unsigned divisions) {
    std::normal_distribution<double> any;
    std::vector<glm::dvec3> bumps;
    for (int i = 0; i < 5; ++i)
        bumps.push_back(glm::normalize(glm::dvec3(any(random), any(random), any(random))));
    return star_shape(divisions, [&](const glm::dvec3& u) {
        double radius = 1;
        for (const glm::dvec3& bump : bumps) {
            const double cosine = std::max(0.0, glm::dot(u, bump));
            radius += 0.8 * cosine * cosine * cosine * cosine * cosine * cosine;
        }
        return radius;
    });
}

/// Pins vertices of \p body, far from each other, at their own directions moved by up to about \p noise.
LandmarkPins random_pins(std::mt19937& random, const MappedMesh& body, std::size_t count, double noise) {
    std::normal_distribution<double> any(0, noise);
    LandmarkPins pins;
    while (pins.vertices.size() < count) {
        const auto vertex = Index(random() % body.points.size());
        bool is_apart = true;
        for (const Index other : pins.vertices)
            is_apart = is_apart && glm::distance(body.points[vertex], body.points[other]) > 0.5;
        if (!is_apart) continue;
        pins.names.push_back(std::to_string(pins.names.size()));
        pins.vertices.push_back(vertex);
        pins.directions.push_back(
            glm::normalize(body.points[vertex] + glm::dvec3(any(random), any(random), any(random))));
    }
    return pins;
}

}  // namespace

TEST_CASE("a flow moves landmarks exactly to their goals, near points along, and far ones not at all") {
    std::vector<glm::dvec3> points = unit_sphere_mesh(3).points;
    const std::vector<glm::dvec3> before = points;
    const std::vector<Index> landmarks = {0, 30};
    const std::vector<glm::dvec3> goals = {glm::normalize(points[0] + glm::dvec3(0.02, 0.01, 0)),
                                           glm::normalize(points[30] + glm::dvec3(0, -0.03, 0.01))};
    flow(points, landmarks, goals, 0.6);
    CHECK(points[0] == goals[0]);
    CHECK(points[30] == goals[1]);
    for (std::size_t v = 0; v < points.size(); ++v) {
        CHECK(glm::length(points[v]) == doctest::Approx(1));
        CHECK(glm::distance(points[v], before[v]) < 0.05);
        if (glm::distance(before[v], before[0]) > 0.7 && glm::distance(before[v], before[30]) > 0.7)
            CHECK(glm::distance(points[v], before[v]) < 1e-15);
    }
}

TEST_CASE("landmarks of random bodies are at their targets to the last bit, and maps are one to one") {
    for (std::uint32_t seed = 0; seed < trials(8); ++seed) {
        CAPTURE(seed);
        std::mt19937 random(seed);
        const MappedMesh body = random_body(random, 3);
        const LandmarkPins pins = random_pins(random, body, 1 + seed, 0.15);
        const PinnedMap map = map_to_pins(body.mesh, pins, {}, {});
        CHECK(fault_of_map(body.mesh, map.points) == "");
        for (std::size_t k = 0; k < pins.vertices.size(); ++k)
            CHECK(map.points[pins.vertices[k]] == pins.directions[k]);
        if (seed >= 2) CHECK(map.agreement.mean_cosine > 0.85);
        if (seed == 4) CHECK(map_to_pins(body.mesh, pins, {}, {}).points == map.points);
    }
}

TEST_CASE("one landmark, and two, turn the map no more than they must") {
    const MappedMesh body = bumpy_ellipsoid(3);
    for (const std::size_t count : {std::size_t{1}, std::size_t{2}}) {
        LandmarkPins pins;
        for (std::size_t k = 0; k < count; ++k) {
            pins.names.push_back(std::to_string(k));
            pins.vertices.push_back(Index(3 * k));
            pins.directions.push_back(body.points[3 * k]);
        }
        const PinnedMap map = map_to_pins(body.mesh, pins, {}, {});
        double mean = 0;
        for (std::size_t v = 0; v < map.points.size(); ++v)
            mean += glm::dot(map.points[v], body.points[v]) / double(map.points.size());
        CHECK(mean > 0.9);
    }
}

TEST_CASE("swapped landmarks are named, and a mirrored set is called mirrored") {
    const MappedMesh body = six_arms(3);
    std::mt19937 random(7);
    LandmarkPins pins = random_pins(random, body, 6, 0.01);
    LandmarkPins mirrored = pins;
    for (glm::dvec3& direction : mirrored.directions) direction.x = -direction.x;
    const auto faults = [&](const LandmarkPins& wrong) {
        try {
            std::string text;
            for (const std::string& each : faults_of(map_to_pins(body.mesh, wrong, {}, {}).agreement, wrong))
                text += each;
            return text;
        } catch (const InputError& error) {
            return std::string(error.what());
        }
    };
    CHECK(faults(pins) == "");
    CHECK(contains(faults(mirrored), "left and right are probably swapped"));
    LandmarkPins far = pins;
    std::swap(far.directions[1], far.directions[4]);
    const std::string text = faults(far);
    CHECK((contains(text, "'1'") || contains(text, "'4'")));
}

TEST_CASE("work on landmarks ends when progress says so") {
    const MappedMesh body = bumpy_ellipsoid(3);
    std::mt19937 random(3);
    const LandmarkPins pins = random_pins(random, body, 5, 0.1);
    int calls = 0;
    map_to_pins(body.mesh, pins, {}, [&](std::string_view, double) { return ++calls > 0; });
    REQUIRE(calls > 5);
    for (const int stop : {1, calls / 2, calls}) {
        int left = stop;
        CHECK_THROWS_AS(
            map_to_pins(body.mesh, pins, {}, [&](std::string_view, double) { return --left > 0; }),
            Cancelled);
    }
}
