#include "fit/correspondence/pull_back.h"

#include <cstddef>
#include <utility>

#include <glm/geometric.hpp>

#include "fit/landmarks/sphere_flow.h"
#include "fit/mesh/half_edge_mesh.h"
#include "fit/sampling/sphere_location.h"
#include "fit/sphere_map/orientation.h"
#include "fit/sphere_map/relaxation.h"

namespace interleaf {
namespace {

/// Rest shapes are blended by this towards equilateral.
constexpr double rest_blend = 0.1;

/// Per vertex, a third of the area of its triangles on the sphere.
std::vector<double> solid_angles(const SphereMesh& mesh, std::span<const glm::dvec3> points) {
    constexpr double least = 1e-12;
    std::vector<double> angles(points.size(), least);
    for (const auto& [a, b, c] : mesh.triangles) {
        const double third = glm::length(glm::cross(points[b] - points[a], points[c] - points[a])) / 6;
        for (const Index vertex : {a, b, c}) angles[vertex] += third;
    }
    return angles;
}

/// Marks the vertices of triangles that are not positive, and those within \p rings rings of triangles, except
/// landmarks.
std::vector<char> sick_vertices(const SphereMesh& mesh, std::span<const glm::dvec3> points, int rings) {
    std::vector<char> sick(points.size(), 0);
    for (const auto& [a, b, c] : mesh.triangles)
        if (orientation(points[a], points[b], points[c]) <= 0) sick[a] = sick[b] = sick[c] = 1;
    for (int ring = 0; ring < rings; ++ring) {
        const std::vector<char> inner = sick;
        for (const auto& [a, b, c] : mesh.triangles)
            if (inner[a] || inner[b] || inner[c]) sick[a] = sick[b] = sick[c] = 1;
    }
    for (const SphereLandmark& landmark : mesh.landmarks) sick[landmark.vertex] = 0;
    return sick;
}

/// Moves the marked vertices to the middle of their neighbors.
void average(const SphereMesh& mesh, const std::vector<char>& are_marked, std::vector<glm::dvec3>& points) {
    std::vector<glm::dvec3> sums(points.size(), glm::dvec3(0));
    for (const Triangle& triangle : mesh.triangles)
        for (std::size_t k = 0; k < 3; ++k)
            if (are_marked[triangle[k]])
                sums[triangle[k]] += points[triangle[(k + 1) % 3]] + points[triangle[(k + 2) % 3]];
    for (std::size_t v = 0; v < points.size(); ++v)
        if (are_marked[v] && glm::dot(sums[v], sums[v]) > 0) points[v] = glm::normalize(sums[v]);
}

/// Untangles, and where that fails averages the surroundings and tries again.
/// \return whether no triangle is turned over
bool untangle_with(const SphereMesh& mesh, Relaxation& relaxation, std::vector<glm::dvec3>& points,
                   ProgressMeter& meter) {
    constexpr int first_sweeps = 200;
    constexpr int further_sweeps = 100;
    constexpr int max_tries = 10;
    bool is_sound = relaxation.untangle(first_sweeps, meter);
    for (int tries = 0; !is_sound && tries < max_tries; ++tries) {
        const std::vector<char> sick = sick_vertices(mesh, points, 1 + tries / 3);
        for (int round = 0; round < 20 + 10 * tries; ++round) {
            meter.step(mesh.triangles.size());
            average(mesh, sick, points);
        }
        is_sound = relaxation.untangle(further_sweeps, meter);
    }
    return is_sound;
}

/// Landmarks stay where they are.
/// \return whether no triangle is turned over
bool untangle_and_sweep(const SphereMesh& mesh, std::vector<glm::dvec3>& points, int sweeps,
                        ProgressMeter& meter) {
    const HalfEdgeMesh half_edges(static_cast<Index>(points.size()), mesh.triangles);
    const std::vector<double> areas = solid_angles(mesh, points);
    Relaxation relaxation(half_edges, mesh.positions, areas, points, Keeps::shapes);
    relaxation.update_shapes(rest_blend);
    for (const SphereLandmark& landmark : mesh.landmarks) relaxation.pin(landmark.vertex);
    const bool is_sound = untangle_with(mesh, relaxation, points, meter);
    if (sweeps > 0) relaxation.sweep(sweeps, meter);
    return is_sound;
}

/// Untangles a map as if it had no landmarks. A smooth flow then carries these to their directions, and hardly turns
/// triangles over.
void untangle_and_carry(SphereMesh mesh, std::vector<glm::dvec3>& points, ProgressMeter& meter) {
    constexpr double radius = 0.8;
    std::vector<Index> vertices;
    std::vector<glm::dvec3> directions;
    for (const SphereLandmark& landmark : std::exchange(mesh.landmarks, {})) {
        vertices.push_back(landmark.vertex);
        directions.push_back(landmark.direction);
    }
    untangle_and_sweep(mesh, points, 0, meter);
    flow(points, vertices, directions, radius);
}

}  // namespace

std::vector<glm::dvec3> pull_back(const SphereMesh& body, const SphereMesh& model,
                                  std::span<const glm::dvec3> on_sphere, ProgressMeter& meter) {
    constexpr int last_sweeps = 10;
    const SphereLocation in_model(model.triangles, on_sphere);
    std::vector<glm::dvec3> located;
    located.reserve(body.points.size());
    Index guess = no_index;
    for (const glm::dvec3& point : body.points) {
        meter.step(20);
        const MeshPoint place = in_model.locate(point, guess);
        guess = place.triangle;
        located.push_back(glm::normalize(place.of(std::span(model.triangles), std::span(model.points))));
    }
    std::vector<glm::dvec3> points = located;
    for (const SphereLandmark& landmark : body.landmarks) points[landmark.vertex] = landmark.direction;
    if (untangle_and_sweep(body, points, last_sweeps, meter) || body.landmarks.empty()) return points;
    untangle_and_carry(body, located, meter);
    untangle_and_sweep(body, located, last_sweeps, meter);
    return located;
}

void untangle(const SphereMesh& mesh, std::vector<glm::dvec3>& points, ProgressMeter& meter) {
    untangle_and_sweep(mesh, points, 0, meter);
}

}  // namespace interleaf
