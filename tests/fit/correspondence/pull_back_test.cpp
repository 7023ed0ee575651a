// The last steps of matching: the map of the model's mesh is inverted, and shapes are restored.
#include "fit/correspondence/pull_back.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

#include "trials.h"
#include <doctest/doctest.h>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include "fit/correspondence/finished_map.h"
#include "fit/correspondence/sphere_mesh.h"
#include "fit/mesh/progress_meter.h"
#include "fit/sphere_map/spherical_map.h"
#include "fit/star_shapes.h"
#include "hierarchy/progress.h"

using namespace interleaf;
using interleaf::testing::MappedMesh;

namespace {

SphereMesh with_map(const MappedMesh& body) {
    return {.triangles = body.mesh.triangles, .positions = body.mesh.positions, .points = body.points};
}

bool is_one_to_one(const SphereMesh& mesh, const std::vector<glm::dvec3>& points) {
    return fault_of_map({.positions = mesh.positions, .triangles = mesh.triangles, .colors = {}}, points)
        .empty();
}

/// The mean conformal distortion of the triangles of \p mesh in space against those on the sphere, 1 for similar ones.
double mean_distortion(const SphereMesh& mesh, const std::vector<glm::dvec3>& points) {
    double sum = 0;
    for (const Triangle& triangle : mesh.triangles) {
        double stretch = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            const auto [a, b, c] = std::array{triangle[k], triangle[(k + 1) % 3], triangle[(k + 2) % 3]};
            const glm::dvec3 u = mesh.positions[b] - mesh.positions[a];
            const glm::dvec3 v = mesh.positions[c] - mesh.positions[a];
            const glm::dvec3 opposite = points[c] - points[b];
            stretch += glm::dot(u, v) / glm::length(glm::cross(u, v)) * glm::dot(opposite, opposite);
        }
        const auto& [a, b, c] = triangle;
        sum += stretch / (2 * glm::length(glm::cross(points[b] - points[a], points[c] - points[a])));
    }
    return sum / double(mesh.triangles.size());
}

}  // namespace

TEST_CASE(
    "landmarks that are moved by more than a star is wide are carried there, and nothing is turned over") {
    const SphereMesh model = with_map(testing::unit_sphere_mesh(3));
    const Progress none;
    for (std::uint32_t seed = 0; seed < trials(20); ++seed) {
        CAPTURE(seed);
        std::mt19937 random{seed};
        SphereMesh body = with_map(testing::unit_sphere_mesh(5));
        std::uniform_int_distribution<std::size_t> any_vertex(0, body.points.size() - 1);
        std::normal_distribution<double> offset(0, 0.2);
        while (body.landmarks.size() < 8) {
            const std::size_t vertex = any_vertex(random);
            const bool is_apart = std::ranges::all_of(body.landmarks, [&](const SphereLandmark& other) {
                return glm::distance(body.points[other.vertex], body.points[vertex]) > 0.6;
            });
            if (!is_apart) continue;
            const glm::dvec3 moved{body.points[vertex].x + offset(random),
                                   body.points[vertex].y + offset(random),
                                   body.points[vertex].z + offset(random)};
            body.landmarks.push_back({static_cast<Index>(vertex), glm::normalize(moved)});
        }
        ProgressMeter meter(none);
        const std::vector<glm::dvec3> points = pull_back(body, model, model.points, meter);
        CHECK(is_one_to_one(body, points));
        for (const SphereLandmark& landmark : body.landmarks)
            CHECK(points[landmark.vertex] == landmark.direction);
    }
}

TEST_CASE("shapes of a long thin part that is twisted come much nearer to rest in many sweeps") {
    const glm::dvec3 tip(0, 0, 1);
    const MappedMesh tailed = testing::star_shape(6, [&](const glm::dvec3& u) {
        constexpr double width = 0.15;
        const glm::dvec3 away = u - tip;
        return 1 + 8 / (1 + glm::dot(away, away) / (width * width));
    });
    const SphereMesh body = with_map(tailed);
    std::vector<glm::dvec3> twisted;
    for (const glm::dvec3& point : body.points)
        twisted.push_back(glm::angleAxis(8 * std::exp(-4 * glm::distance(point, tip)), tip) * point);
    REQUIRE(is_one_to_one(body, twisted));
    const auto distortion_after = [&](int sweeps) {
        const Progress none;
        ProgressMeter meter(none);
        std::vector<glm::dvec3> points = twisted;
        CHECK(restore_shapes(body, 1.3, sweeps, points, meter));
        CHECK(is_one_to_one(body, points));
        return mean_distortion(body, points);
    };
    const double few = distortion_after(usual_sweeps);
    CHECK(few < mean_distortion(body, twisted));
    CHECK(distortion_after(1000) - 1 < 0.75 * (few - 1));
}
