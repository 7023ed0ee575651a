#include "fit/preview.h"

#include <optional>
#include <utility>

#include <glm/geometric.hpp>

#include "fit/aligned_map.h"
#include "fit/landmark_fitting.h"
#include "fit/landmarks/landmark_report.h"
#include "fit/landmarks/pinned_map.h"
#include "fit/mesh/space_triangle.h"
#include "fit/mesh/surface_distance.h"
#include "fit/sampling/sphere_location.h"
#include "fit/sampling/surface_sampling.h"
#include "fit/sphere_map/spherical_map.h"

namespace interleaf {
namespace {

/// The part of the work that the map takes.
constexpr double sampling_starts = 0.8;

Hierarchy sampled_key(const SurfaceMesh& mesh, std::vector<glm::dvec3>& points,
                      const std::optional<glm::dmat3>& rotation, const PreviewOptions& options,
                      const Progress& progress) {
    const AlignedMap map(mesh, SurfaceMesh{}, std::move(points), false, rotation, false);
    const SampledSurface surface =
        sample_surface(map.mapped, options.roots, {.leaves = options.leaves, .max_leveling = 0}, progress);
    points = map.points;
    return hierarchy_from_leaves(options.roots.complex, surface.leaves, surface.positions, {});
}

std::vector<glm::dvec3> free_map(const SurfaceMesh& mesh, const Progress& progress) {
    SphericalMap map = map_to_sphere(mesh, progress);
    center_map(mesh, map.points);
    return std::move(map.points);
}

}  // namespace

PreviewReference preview_reference(SurfaceMesh mesh, const PreviewOptions& options,
                                   const Progress& progress) {
    PreviewReference reference{.mesh = std::move(mesh), .points = {}, .key = {}};
    reference.points = free_map(reference.mesh, part_of(progress, 0, sampling_starts));
    reference.key = sampled_key(reference.mesh, reference.points, options.rotation, options,
                                part_of(progress, sampling_starts, 1));
    return reference;
}

PreviewReference preview_reference(Hierarchy key, const SphereRoots& roots) {
    PreviewReference reference{.mesh = surface_of(key), .points = sphere_points_of(key, roots), .key = {}};
    reference.key = std::move(key);
    return reference;
}

std::vector<Landmark> targets_on(const PreviewReference& reference, std::span<const Landmark> landmarks) {
    const SurfaceDistance distance(reference.mesh.triangles, reference.mesh.positions);
    const std::span<const Triangle> triangles = reference.mesh.triangles;
    const std::span<const glm::dvec3> positions = reference.mesh.positions;
    std::vector<Landmark> targets;
    targets.reserve(landmarks.size());
    for (const Landmark& landmark : landmarks) {
        MeshPoint point;
        distance(landmark.position, point.triangle);
        const auto& [a, b, c] = triangles[point.triangle];
        point.barycentric = nearest_place(landmark.position, {positions[a], positions[b], positions[c]});
        targets.push_back({landmark.name, point.of(triangles, positions),
                           landmark.direction.value_or(glm::normalize(
                               point.of(triangles, std::span<const glm::dvec3>(reference.points))))});
    }
    return targets;
}

PreviewKey preview_key(const SurfaceMesh& mesh, const AimedLandmarks& aimed,
                       std::span<const std::array<std::string, 2>> symmetric, const PreviewOptions& options,
                       const Progress& progress) {
    const Progress mapping = part_of(progress, 0, sampling_starts);
    const Progress sampling = part_of(progress, sampling_starts, 1);
    PreviewKey preview;
    const std::optional<PinnedMesh> pinned = pinned_mesh(mesh, aimed.landmarks, symmetric, aimed.positions);
    if (pinned) {
        PinnedMap map = map_to_pins(pinned->mesh, pinned->pins, {}, mapping);
        preview.agreement = std::move(map.agreement);
        preview.faults = faults_of(preview.agreement, pinned->pins);
        preview.key = sampled_key(pinned->mesh, map.points, std::nullopt, options, sampling);
    } else {
        std::vector<glm::dvec3> points = free_map(mesh, mapping);
        preview.key = sampled_key(mesh, points, options.rotation, options, sampling);
    }
    return preview;
}

}  // namespace interleaf
