#include "fit/landmark_fitting.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>

#include <fmt/core.h>
#include <glm/geometric.hpp>

#include "fit/landmarks/landmark_insertion.h"
#include "fit/mesh/space_triangle.h"
#include "fit/mesh/surface_distance.h"
#include "hierarchy/error.h"
#include "text/shown_text.h"

namespace interleaf {

void check_directions(std::span<const Landmark> landmarks) {
    for (const Landmark& landmark : landmarks)
        if (landmark.direction.has_value() != landmarks.front().direction.has_value())
            throw UsageError("some landmarks have a direction and some have none, expected all or none");
}

std::optional<PinnedMesh> pinned_mesh(const SurfaceMesh& mesh, std::span<const Landmark> landmarks,
                                      std::span<const std::array<std::string, 2>> symmetric,
                                      std::span<const glm::dvec3> counterparts) {
    if (landmarks.empty()) return {};
    MeshWithLandmarks inserted = insert_landmarks(mesh, landmarks);
    if (!landmarks.front().direction) return {};
    PinnedMesh pinned{std::move(inserted.mesh),
                      {.names = {}, .vertices = inserted.vertices, .directions = {}}};
    for (const Landmark& landmark : landmarks) {
        const auto same = std::ranges::find(pinned.pins.directions, *landmark.direction);
        if (same != pinned.pins.directions.end())
            throw InputError(
                fmt::format("the landmarks '{}' and '{}' have the same direction, expected different ones",
                            shown_text(pinned.pins.names[std::size_t(same - pinned.pins.directions.begin())]),
                            shown_text(landmark.name)));
        pinned.pins.names.push_back(landmark.name);
        pinned.pins.directions.push_back(*landmark.direction);
    }
    pinned.pins.counterparts.assign(counterparts.begin(), counterparts.end());
    if (!counterparts.empty())
        for (const Landmark& landmark : landmarks) pinned.pins.positions.push_back(landmark.position);
    for (const auto& [left, right] : symmetric) {
        const std::vector<std::string>& names = pinned.pins.names;
        const auto a = std::ranges::find(names, left);
        const auto b = std::ranges::find(names, right);
        if (a != names.end() && b != names.end())
            pinned.pins.symmetric.push_back({std::size_t(a - names.begin()), std::size_t(b - names.begin())});
    }
    return pinned;
}

std::vector<FittedLandmark> fitted_landmarks(std::span<const Landmark> landmarks, const AlignedMap& map,
                                             const KeyOverRoots& key) {
    const double diagonal = box_diagonal(map.original);
    std::vector<FittedLandmark> fitted;
    fitted.reserve(landmarks.size());
    std::optional<SurfaceDistance> from_original;  // where the mapped mesh is another surface
    if (map.is_approximate && !landmarks.empty())
        from_original.emplace(map.original.triangles, map.original.positions);
    for (const Landmark& landmark : landmarks) {
        FittedLandmark each{.name = landmark.name};
        const MeshPoint point = map.mapped.nearest_point(landmark.position);
        each.position = map.mapped.position(point);
        if (from_original) {
            Index nearest = no_index;
            each.position = from_original->nearest_point(landmark.position, nearest);
        }
        each.from_mesh = glm::distance(each.position, landmark.position) / diagonal;
        each.direction = landmark.direction.value_or(map.mapped.direction(point));
        each.off_in_key =
            glm::distance(each.position, point_in_direction(key.hierarchy, key.roots, each.direction)) /
            diagonal;
        fitted.push_back(std::move(each));
    }
    return fitted;
}

std::vector<std::string> faults_of_places(std::span<const FittedLandmark> landmarks) {
    constexpr double far = 0.01;
    std::vector<std::string> faults;
    for (const FittedLandmark& landmark : landmarks)
        if (landmark.from_mesh > far)
            faults.push_back(
                fmt::format("the landmark '{}' is {:.3g} % of the box diagonal away from the mesh, and moves "
                            "to its nearest point",
                            shown_text(landmark.name), 100 * landmark.from_mesh));
    return faults;
}

}  // namespace interleaf
