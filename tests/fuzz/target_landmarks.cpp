// A landmark file.
#include <cmath>
#include <set>
#include <string>
#include <string_view>

#include "fuzz/target.h"
#include <glm/geometric.hpp>

#include "io/landmarks/landmark_file.h"

namespace interleaf::fuzz {

namespace {

std::string inspected(const LandmarkSet& set) {
    if (set.landmarks.empty() || set.landmarks.size() > max_landmarks) return "unsound: number of landmarks";
    std::set<std::string> names;
    for (const Landmark& landmark : set.landmarks) {
        if (landmark.name.empty() || !names.insert(landmark.name).second) return "unsound: names";
        for (int axis = 0; axis < 3; ++axis)
            if (!(std::abs(landmark.position[axis]) <= 1e30)) return "unsound: position";
        if (landmark.direction && !(std::abs(glm::length(*landmark.direction) - 1) < 1e-12))
            return "unsound: direction";
    }
    for (const auto& [left, right] : set.symmetric)
        if (!names.contains(left) || !names.contains(right) || left == right) return "unsound: pair";
    const std::string text = landmarks_text(set);
    return landmarks_text(parse_landmarks(text, "again.json")) == text ? ""
                                                                       : "changed by writing and reading";
}

Inspection read(ByteSpan bytes) {
    const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    return [set = parse_landmarks(text, "landmarks.json")] { return inspected(set); };
}

}  // namespace

const Target target{"landmarks", read, whole_as_part, first_part, own_size};

}  // namespace interleaf::fuzz
