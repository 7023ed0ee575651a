#include "fit/aligned_map.h"

#include <cstddef>
#include <utility>

#include "fit/mesh/surface_distance.h"
#include "fit/sampling/leaf_faults.h"
#include "fit/sampling/leaf_smoothing.h"
#include "fit/sphere_map/alignment.h"

namespace interleaf {
namespace {

/// Maximum number of vertices, per leaf, that may look for better places on a refined mesh, and over a matched map. On
/// a body so long that most leaves stay needles, and where a match stretches the surface, further rounds take time and
/// improve little.
constexpr double tries_per_leaf = 0.5;
/// The same per round on a refined mesh.
constexpr double tries_per_leaf_and_round = 0.25;

/// On a mesh that is not refined, tries_per_leaf is the maximum if more than this fraction of the leaves needs smoothing.
constexpr double faulty_part_of_many = 0.3;
/// But where the triangles of that mesh are large, or landmarks pull at its map, leaves get better for longer.
constexpr double tries_per_leaf_if_better = 2;

/// There, and over a matched map, further rounds go through the worst leaves only, with at most this many vertices per
/// leaf of the key. The leaves with the least angles and those that face away still improve.
constexpr double tries_of_worst_per_leaf = 0.1;

/// Leaves with an angle below this, in degrees, are worth a greater distance: a key is poor below 5, and a match is not
/// taken below 3.
constexpr double needle_angle = 5;
/// But not one beyond this fraction of the accepted distance, unless the map is matched: a match with needles is lost.
constexpr double safely_accepted = 0.9;

}  // namespace

AlignedMap::AlignedMap(const SurfaceMesh& original_mesh, SurfaceMesh fine_mesh, std::vector<glm::dvec3> map,
                       bool approximates, const std::optional<glm::dmat3>& rotation,
                       bool is_of_large_triangles, std::span<const glm::dvec3> landmarks)
    : original(original_mesh),
      has_large_triangles(is_of_large_triangles),
      is_matched(false),
      is_approximate(approximates),
      fine(std::move(fine_mesh)),
      points(std::move(map)),
      mean_cosine(align(rotation.has_value())),
      mapped(mesh(), rotated(rotation), landmarks) {}

AlignedMap::AlignedMap(const SurfaceMesh& original_mesh, SurfaceMesh fine_mesh, std::vector<glm::dvec3> map,
                       bool approximates, std::span<const glm::dvec3> landmarks)
    : original(original_mesh),
      has_large_triangles(false),
      is_matched(true),
      is_approximate(approximates),
      fine(std::move(fine_mesh)),
      points(std::move(map)),
      mean_cosine(interleaf::mean_cosine(mesh(), points)),
      mapped(mesh(), points, landmarks) {}

double AlignedMap::align(bool is_turned) {
    if (is_turned) rotate(points, rotation_to_surface(mesh(), points));
    return interleaf::mean_cosine(mesh(), points);
}

std::span<const glm::dvec3> AlignedMap::rotated(const std::optional<glm::dmat3>& rotation) {
    if (rotation) rotate(points, *rotation);
    return points;
}

void smooth(const AlignedMap& map, const SphereRoots& roots, SampledSurface& surface,
            double accepted_distance, const Progress& progress) {
    const double leaves = double(surface.leaves.size());
    SmoothingLimits limits;
    limits.needle_angle = needle_angle;
    if (!map.is_matched)
        limits.needle_distance = safely_accepted * accepted_distance * box_diagonal(map.original);
    const auto tries = [&](double per_leaf) { return static_cast<std::size_t>(per_leaf * leaves); };
    if (map.is_matched) {
        limits.tries = tries(tries_per_leaf);
        limits.tries_of_worst = tries(tries_of_worst_per_leaf);
    } else if (map.is_refined()) {
        limits.tries = tries(tries_per_leaf);
        limits.tries_per_round = tries(tries_per_leaf_and_round);
    } else if (double(count_faulty_leaves(map.mapped, surface)) > faulty_part_of_many * leaves) {
        const bool gets_better = map.has_large_triangles || !map.mapped.landmarks.empty();
        limits.tries = tries(gets_better ? tries_per_leaf_if_better : tries_per_leaf);
        limits.tries_of_worst = tries(tries_of_worst_per_leaf);
    }
    const Index fixed = roots.complex.vertex_count();
    if (map.is_approximate) {
        const SurfaceDistance original(map.original.triangles, map.original.positions);
        smooth_leaves(map.mapped, fixed, surface, progress, limits, &original);
    } else {
        smooth_leaves(map.mapped, fixed, surface, progress, limits);
    }
}

FitQuality quality_of(const AlignedMap& map, const SampledSurface& surface, const Progress& progress) {
    return measure_quality(map.mapped, map.original, surface, progress);
}

}  // namespace interleaf
