// Landmarks that are probably wrong are named: swapped neighbors, swapped sides.
#include "fit/landmarks/landmark_agreement.h"

#include <cstdint>
#include <random>
#include <utility>

#include "messages.h"
#include "trials.h"
#include <doctest/doctest.h>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/trigonometric.hpp>

using namespace interleaf;

namespace {

/// Nose, two ears close to each other, four feet and a tail, as a four-legged animal has them on the sphere.
LandmarkPins animal() {
    LandmarkPins pins;
    const auto add = [&](const char* name, const glm::dvec3& direction) {
        pins.names.emplace_back(name);
        pins.vertices.push_back(static_cast<Index>(pins.vertices.size()));
        pins.directions.push_back(glm::normalize(direction));
    };
    add("nose", {1, 0.2, 0});
    add("left ear", {0.9, 0.6, 0.15});
    add("right ear", {0.9, 0.6, -0.15});
    add("left hand", {0.6, -1, 0.4});
    add("right hand", {0.6, -1, -0.4});
    add("left foot", {-0.6, -1, 0.4});
    add("right foot", {-0.6, -1, -0.4});
    add("tail", {-1, 0.3, 0});
    pins.symmetric = {{1, 2}, {3, 4}, {5, 6}};
    return pins;
}

/// The landmarks of another animal: moved by about \p noise, and turned as a whole.
std::vector<glm::dvec3> other_animal(const LandmarkPins& pins, double noise, std::uint32_t seed) {
    std::mt19937 random(seed);
    std::normal_distribution<double> any(0, noise);
    std::vector<glm::dvec3> points;
    for (const glm::dvec3& direction : pins.directions) {
        const glm::dvec3 moved =
            glm::normalize(direction + glm::dvec3(any(random), any(random), any(random)));
        points.emplace_back(0.8 * moved.x - 0.6 * moved.y, 0.6 * moved.x + 0.8 * moved.y, moved.z);
    }
    return points;
}

std::string text_of(const std::vector<glm::dvec3>& points, const LandmarkPins& pins) {
    std::string text;
    for (const std::string& fault : faults_of(agreement_of(points, pins), pins)) text += fault + ".";
    return text;
}

}  // namespace

TEST_CASE("right landmarks of another body raise no doubt") {
    const LandmarkPins pins = animal();
    for (std::uint32_t seed = 0; seed < trials(50); ++seed) {
        CAPTURE(seed);
        CHECK(text_of(other_animal(pins, 0.07, seed), pins) == "");
    }
}

TEST_CASE("two swapped landmarks near each other are named") {
    const LandmarkPins pins = animal();
    for (std::uint32_t seed = 0; seed < trials(50); ++seed) {
        CAPTURE(seed);
        std::vector<glm::dvec3> points = other_animal(pins, 0.03, seed);
        std::swap(points[1], points[2]);
        CHECK(contains(text_of(points, pins), "'left ear' and 'right ear' lie the other way round"));
        CHECK_FALSE(agreement_of(points, pins).is_doubtful());
    }
}

TEST_CASE("a head that is turned as a whole is not taken for swapped ears") {
    const LandmarkPins pins = animal();
    const glm::dvec3 middle = glm::normalize(pins.directions[0] + pins.directions[1] + pins.directions[2]);
    for (const double degrees : {-170.0, -130.0, 130.0, 170.0}) {
        CAPTURE(degrees);
        std::vector<glm::dvec3> points = pins.directions;
        for (std::size_t i = 0; i < 3; ++i)
            points[i] = glm::angleAxis(glm::radians(degrees), middle) * points[i];
        CHECK(text_of(points, pins) == "");
    }
}

TEST_CASE("neighbors that only the map to the sphere turns round are not taken for swapped ones") {
    LandmarkPins pins = animal();
    for (std::uint32_t seed = 0; seed < trials(50); ++seed) {
        CAPTURE(seed);
        std::vector<glm::dvec3> points = other_animal(pins, 0.03, seed);
        // Both bodies look alike in space, but have any size, place and position there.
        pins.counterparts.clear();
        pins.positions.clear();
        for (std::size_t i = 0; i < points.size(); ++i) {
            pins.counterparts.push_back(3.0 * pins.directions[i] + glm::dvec3(1, 2, 3));
            pins.positions.push_back(0.5 * points[i]);
        }
        std::swap(points[1], points[2]);
        CHECK(text_of(points, pins) == "");
        // The ears of a head that looks back: they are swapped in space, too.
        const glm::dvec3 neck = glm::normalize(pins.directions[1] + pins.directions[2]);
        for (std::size_t i = 0; i < 3; ++i)
            pins.counterparts[i] = glm::angleAxis(glm::radians(80.0), neck) * pins.counterparts[i];
        std::swap(pins.positions[1], pins.positions[2]);
        CHECK(contains(text_of(points, pins), "'left ear' and 'right ear' lie the other way round"));
    }
}

TEST_CASE("hands and feet that are both swapped are not taken for a body that is turned about") {
    LandmarkPins pins;
    const auto add = [&](const char* name, const glm::dvec3& place) {
        pins.names.emplace_back(name);
        pins.vertices.push_back(static_cast<Index>(pins.vertices.size()));
        pins.positions.push_back(place);
        pins.directions.push_back(glm::normalize(place));
    };
    // Hands and feet are near each other, and nearly in one plane with the head.
    add("right hand", {-0.4, 0.4, -0.06});
    add("left hand", {0.4, 0.4, -0.06});
    add("nose", {0, 1, 0.1});
    add("chin", {0, 0.7, 0.4});
    add("right foot", {-0.15, -1, 0.1});
    add("left foot", {0.15, -1, 0.1});
    pins.counterparts = pins.positions;
    CHECK(text_of(pins.directions, pins) == "");
    const std::vector<glm::dvec3> points = pins.directions;
    for (const std::size_t right : {0U, 4U}) {
        std::swap(pins.directions[right], pins.directions[right + 1]);
        std::swap(pins.counterparts[right], pins.counterparts[right + 1]);
    }
    CHECK(contains(text_of(points, pins), "lie the other way round"));
}

TEST_CASE("swapped sides are found from the symmetric pairs") {
    LandmarkPins pins = animal();
    std::vector<glm::dvec3> points = other_animal(pins, 0.05, 4);
    for (const auto& [left, right] : pins.symmetric) std::swap(points[left], points[right]);
    CHECK(contains(text_of(points, pins), "left and right exchanged, such as 'left ear' and 'right ear'"));
    const LandmarkAgreement agreement = agreement_of(points, pins);
    CHECK(agreement.exchanged_cosine > agreement.mean_cosine);
}

TEST_CASE("a standing man's five landmarks, nearly in one plane, raise no doubt about sides") {
    LandmarkPins pins;
    std::vector<glm::dvec3> points;
    const auto add = [&](const char* name, const glm::dvec3& direction, const glm::dvec3& point) {
        pins.names.emplace_back(name);
        pins.vertices.push_back(static_cast<Index>(pins.vertices.size()));
        pins.directions.push_back(glm::normalize(direction));
        points.push_back(glm::normalize(point));
    };
    // One man holds his hands before him, the other one behind, and lower.
    add("right hand", {-1, 0.6, 0.2}, {-1, -0.1, -0.15});
    add("left hand", {1, 0.6, 0.2}, {1, -0.1, -0.15});
    add("nose", {0, 1, 0.1}, {0, 1, -0.05});
    add("right foot", {-0.2, -1, 0.1}, {-0.1, -1, -0.1});
    add("left foot", {0.2, -1, 0.1}, {0.1, -1, -0.1});
    pins.symmetric = {{0, 1}, {3, 4}};
    const LandmarkAgreement agreement = agreement_of(points, pins);
    CHECK(agreement.exchanged_cosine > agreement.mean_cosine);
    CHECK(text_of(points, pins) == "");
    pins.symmetric.clear();
    CHECK(text_of(points, pins) == "");
}

TEST_CASE("mirrored landmarks of an animal are found with and without symmetric pairs") {
    LandmarkPins pins = animal();
    for (std::uint32_t seed = 0; seed < trials(50); ++seed) {
        CAPTURE(seed);
        std::vector<glm::dvec3> points = other_animal(pins, 0.03, seed);
        for (glm::dvec3& point : points) point.z = -point.z;
        CHECK(contains(text_of(points, pins), "left and right"));
        LandmarkPins without_pairs = pins;
        without_pairs.symmetric.clear();
        CHECK(contains(text_of(points, without_pairs), "fit better mirrored"));
    }
}
