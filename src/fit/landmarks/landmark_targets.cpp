#include "fit/landmarks/landmark_targets.h"

#include <algorithm>
#include <cstddef>

#include <fmt/core.h>

#include "hierarchy/error.h"
#include "text/shown_text.h"

namespace interleaf {

AimedLandmarks aim(std::span<const Landmark> landmarks, std::span<const Landmark> targets) {
    AimedLandmarks aimed;
    for (const Landmark& landmark : landmarks) {
        const auto target = std::ranges::find(targets, landmark.name, &Landmark::name);
        if (target == targets.end()) {
            aimed.remarks.push_back(
                fmt::format("the landmark '{}' is not among those of the first mesh, and "
                            "has no effect",
                            shown_text(landmark.name)));
            continue;
        }
        aimed.landmarks.push_back({landmark.name, landmark.position, target->direction});
        aimed.positions.push_back(target->position);
    }
    for (const Landmark& target : targets)
        if (std::ranges::find(landmarks, target.name, &Landmark::name) == landmarks.end())
            aimed.remarks.push_back(
                fmt::format("the landmark '{}' of the first mesh is missing here", shown_text(target.name)));
    if (aimed.landmarks.empty())
        throw InputError("no landmark has the name of a landmark of the first mesh, expected the same names");
    return aimed;
}

std::optional<Similarity> placement_of(const AimedLandmarks& aimed, std::optional<LandmarkPlacing> placing) {
    constexpr std::size_t fewest = 3;
    const std::size_t count = aimed.landmarks.size();
    const LandmarkPlacing kind =
        placing.value_or(count < fewest ? LandmarkPlacing::keep : LandmarkPlacing::similarity);
    if (kind == LandmarkPlacing::keep) return {};
    if (count < fewest)
        throw InputError(
            fmt::format("{} landmarks do not place a mesh in space, expected at least {}; --place keep "
                        "leaves it where it is",
                        count, fewest));
    std::vector<glm::dvec3> from;
    from.reserve(count);
    for (const Landmark& landmark : aimed.landmarks) from.push_back(landmark.position);
    try {
        return fit_similarity(from, aimed.positions, kind == LandmarkPlacing::similarity);
    } catch (const InputError& error) {
        throw InputError(fmt::format("{}; --place keep leaves the mesh where it is", error.what()));
    }
}

}  // namespace interleaf
