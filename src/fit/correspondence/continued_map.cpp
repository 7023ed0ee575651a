#include "fit/correspondence/continued_map.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <glm/geometric.hpp>

#include "fit/correspondence/even_mesh.h"
#include "fit/correspondence/finished_map.h"
#include "fit/correspondence/pull_back.h"
#include "fit/mesh/progress_meter.h"
#include "fit/mesh/space_triangle.h"
#include "fit/mesh/surface_distance.h"
#include "fit/sphere_map/spherical_map.h"
#include "hierarchy/error.h"

namespace interleaf {
namespace {

/// A vertex that is farther from the surface before has no place on it that it surely comes from; in square roots of
/// the area.
constexpr double far_away = 0.1;

/// The area of a surface and its center.
struct Spread {
    double area = 0;
    glm::dvec3 center{0};
};

Spread spread_of(const SurfaceMesh& mesh) {
    const glm::dvec3 first = mesh.positions.front();
    Spread spread;
    for (const auto& [a, b, c] : mesh.triangles) {
        const TriangleCorners corners = {mesh.positions[a], mesh.positions[b], mesh.positions[c]};
        const double area = doubled_area(corners) / 2;
        spread.area += area;
        spread.center += area / 3 * (corners[0] + corners[1] + corners[2] - 3.0 * first);
    }
    if (!(spread.area > 0)) throw InputError("the surface has no area");
    spread.center = first + spread.center / spread.area;
    return spread;
}

/// The nearest places of some points on a surface.
struct NearestPlaces {
    std::vector<glm::dvec3> points;  ///< what the map of the surface has there
    double mean = 0;                 ///< distance
    double largest = 0;
};

NearestPlaces nearest_places(std::span<const glm::dvec3> places, std::span<const Triangle> triangles,
                             std::span<const glm::dvec3> positions, std::span<const glm::dvec3> points,
                             ProgressMeter& meter) {
    const SurfaceDistance distance(triangles, positions);
    NearestPlaces found;
    found.points.reserve(places.size());
    Index nearest = no_index;
    for (const glm::dvec3& place : places) {
        meter.step(40);
        const double away = distance(place, nearest);
        found.mean += away / double(places.size());
        found.largest = std::max(found.largest, away);
        const auto& [a, b, c] = triangles[nearest];
        const glm::dvec3 at = nearest_place(place, {positions[a], positions[b], positions[c]});
        found.points.push_back(glm::normalize(at.x * points[a] + at.y * points[b] + at.z * points[c]));
    }
    return found;
}

/// \p positions as they are, moved from one center to the other, and scaled there.
std::array<std::vector<glm::dvec3>, 3> candidates_of(const std::vector<glm::dvec3>& positions,
                                                     const Spread& from, const Spread& to) {
    std::array<std::vector<glm::dvec3>, 3> candidates = {positions, positions, positions};
    const double scale = std::sqrt(to.area / from.area);
    for (glm::dvec3& position : candidates[1]) position += to.center - from.center;
    for (glm::dvec3& position : candidates[2]) position = scale * (position - from.center) + to.center;
    return candidates;
}

}  // namespace

ContinuedMap continued_map(const SurfaceMesh& before, std::span<const glm::dvec3> points,
                           const SurfaceMesh& mesh, std::size_t vertices, const Progress& progress) {
    ProgressMeter meter(progress);
    meter.enter("continuing the map", 0);
    const Spread spread = spread_of(mesh);
    // The points of the sphere are not known yet: those of all vertices are the same, and stay so at middles.
    const double scale = 1 / std::sqrt(spread.area);
    SphereMesh body{mesh.triangles, {}, std::vector<glm::dvec3>(mesh.positions.size(), {1, 0, 0})};
    for (const glm::dvec3& position : mesh.positions) body.positions.push_back(scale * position);
    const auto halved = split_long_edges(body, vertices, meter);
    SurfaceMesh whole = with_middles(mesh, halved, body.triangles);

    NearestPlaces best;
    for (const auto& positions : candidates_of(before.positions, spread_of(before), spread)) {
        NearestPlaces places = nearest_places(whole.positions, before.triangles, positions, points, meter);
        if (best.points.empty() || places.mean < best.mean) best = std::move(places);
    }
    if (scale * best.largest > far_away) return {std::move(whole), std::move(body), {}};
    meter.set_part(0.5);
    untangle(body, best.points, meter);
    return {std::move(whole), std::move(body), std::move(best.points)};
}

std::vector<glm::dvec3> with_restored_shapes(const ContinuedMap& map, double worst_shape,
                                             const Progress& progress) {
    ProgressMeter meter(progress);
    meter.enter("continuing the map", 0);
    std::vector<glm::dvec3> points = map.points;
    restore_shapes(map.body, worst_shape, usual_sweeps, points, meter);
    if (!fault_of_map(map.mesh, points).empty()) points.clear();
    return points;
}

}  // namespace interleaf
