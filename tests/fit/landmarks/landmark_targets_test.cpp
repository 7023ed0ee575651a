// Landmarks match by name, and place a mesh where an exact similarity would.
#include "fit/landmarks/landmark_targets.h"

#include <random>

#include "messages.h"
#include "thrown_errors.h"
#include <doctest/doctest.h>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

using namespace interleaf;

namespace {

std::vector<Landmark> random_landmarks(std::mt19937& random, std::size_t count) {
    std::uniform_real_distribution<double> any(-1, 1);
    std::vector<Landmark> landmarks;
    for (std::size_t k = 0; k < count; ++k)
        landmarks.push_back({std::string(1, char('a' + k)), {any(random), any(random), any(random)}});
    return landmarks;
}

}  // namespace

TEST_CASE("a similarity is recovered exactly, and a rigid placement does not scale") {
    std::mt19937 random(11);
    std::uniform_real_distribution<double> any(-1, 1);
    for (int trial = 0; trial < 50; ++trial) {
        CAPTURE(trial);
        std::vector<Landmark> landmarks = random_landmarks(random, 3 + std::size_t(trial) % 5);
        const glm::dmat3 turn(glm::rotate(glm::dmat4(1), 3 * any(random),
                                          glm::normalize(glm::dvec3(any(random), any(random), 1.5))));
        const double scale = 0.1 + 5 * std::abs(any(random));
        const glm::dvec3 shift(100 * any(random), 10, any(random));
        std::vector<Landmark> targets = landmarks;
        for (Landmark& each : targets) {
            each.position = scale * (turn * each.position) + shift;
            each.direction = glm::dvec3(0, 0, 1);
        }
        std::swap(targets[0], targets[2]);  // names decide, not the order
        const AimedLandmarks aimed = aim(landmarks, targets);
        CHECK(aimed.remarks.empty());
        const auto similarity = placement_of(aimed, {});
        REQUIRE(similarity);
        const auto rigid = placement_of(aimed, LandmarkPlacing::rigid);
        REQUIRE(rigid);
        CHECK(rigid->scale == 1);
        CHECK(similarity->scale == doctest::Approx(scale).epsilon(1e-12));
        for (std::size_t k = 0; k < landmarks.size(); ++k)
            CHECK(glm::distance((*similarity)(landmarks[k].position), aimed.positions[k]) < 1e-12 * 200);
        const glm::dvec3 any_point(any(random), any(random), any(random));
        CHECK(glm::distance((*similarity)(any_point), scale * (turn * any_point) + shift) < 1e-10);
        CHECK(glm::determinant(rigid->rotation) == doctest::Approx(1));
        CHECK_FALSE(placement_of(aimed, LandmarkPlacing::keep));
    }
}

TEST_CASE("names that only one side has are remarked, and no common name is an error") {
    std::mt19937 random(5);
    const std::vector<Landmark> landmarks = random_landmarks(random, 4);
    std::vector<Landmark> targets = random_landmarks(random, 5);
    targets[0].name = "hump";
    const AimedLandmarks aimed = aim(landmarks, targets);
    CHECK(aimed.landmarks.size() == 3);
    REQUIRE(aimed.remarks.size() == 3);
    CHECK(contains(aimed.remarks[0], "'a' is not among those of the first mesh"));
    CHECK(contains(aimed.remarks[1], "'hump' of the first mesh is missing"));
    const std::vector<Landmark> others = {{"x", {}}};
    CHECK(contains(input_error_of([&] { aim(others, targets); }), "expected the same names"));
}

TEST_CASE("landmarks that leave the placement open are refused, or keep the mesh where it is") {
    std::mt19937 random(6);
    const std::vector<Landmark> two = random_landmarks(random, 2);
    CHECK_FALSE(placement_of(aim(two, two), {}));
    CHECK(contains(input_error_of([&] { placement_of(aim(two, two), LandmarkPlacing::similarity); }),
                   "expected at least 3"));
    std::vector<Landmark> line = random_landmarks(random, 4);
    for (std::size_t k = 0; k < 4; ++k) line[k].position = glm::dvec3(1, 2, 3) * double(k * k);
    CHECK(contains(input_error_of([&] { placement_of(aim(line, line), {}); }), "on one line"));
    CHECK(contains(input_error_of([&] { placement_of(aim(line, line), {}); }), "--place keep"));
}
