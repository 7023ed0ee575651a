#include "io/landmarks/landmark_file.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <set>
#include <utility>
#include <vector>

#include <fmt/core.h>
#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>

#include "io/file/input_file.h"
#include "io/text/joined_text.h"
#include "text/characters.h"

namespace interleaf {
namespace {

constexpr std::string_view format_name = "interleaf-landmarks";
constexpr int format_version = 1;
constexpr std::uint64_t max_file_size = 1 << 20;
constexpr double largest_coordinate = 1e30;

glm::dvec3 vector_at(const JsonPlace& place) {
    if (place.size() != 3) place.fail_expecting("three numbers");
    return {place.element(0).number(), place.element(1).number(), place.element(2).number()};
}

glm::dvec3 position_at(const JsonPlace& place) {
    const glm::dvec3 position = vector_at(place);
    for (int axis = 0; axis < 3; ++axis)
        if (std::abs(position[axis]) > largest_coordinate)
            place.element(std::size_t(axis))
                .fail_expecting(fmt::format("a coordinate from -{0} to {0}", largest_coordinate));
    return position;
}

std::string landmark_name_at(const JsonPlace& place) {
    std::string name = place.string();
    if (name.empty() || !is_printable(name))
        place.fail_expecting("a name that is not empty, without control characters");
    return name;
}

std::vector<Landmark> landmarks_at(const JsonPlace& place) {
    if (place.size() == 0 || place.size() > max_landmarks)
        place.fail(fmt::format("has {} landmarks, expected 1 to {}", place.size(), max_landmarks));
    std::vector<Landmark> landmarks;
    std::set<std::string> names;
    for (std::size_t i = 0; i < place.size(); ++i) {
        const JsonPlace each = place.element(i);
        const JsonPlace name = each.member("name");
        Landmark landmark{landmark_name_at(name), position_at(each.member("position"))};
        if (!names.insert(landmark.name).second) name.fail_expecting("a name that no other landmark has");
        if (const auto direction = each.optional_member("direction"))
            landmark.direction = direction_at(*direction);
        landmarks.push_back(std::move(landmark));
    }
    return landmarks;
}

std::vector<std::array<std::string, 2>> symmetric_at(const JsonPlace& place,
                                                     const std::vector<Landmark>& landmarks) {
    std::vector<std::array<std::string, 2>> pairs;
    std::set<std::string> used;
    for (std::size_t i = 0; i < place.size(); ++i) {
        const JsonPlace pair = place.element(i);
        if (pair.size() != 2) pair.fail_expecting("two names of landmarks");
        for (std::size_t side = 0; side < 2; ++side) {
            const JsonPlace name = pair.element(side);
            const std::string text = name.string();
            if (std::ranges::find(landmarks, text, &Landmark::name) == landmarks.end())
                name.fail_expecting("the name of a landmark");
            if (!used.insert(text).second) name.fail_expecting("a name that no other pair has");
        }
        pairs.push_back({pair.element(0).string(), pair.element(1).string()});
    }
    return pairs;
}

nlohmann::ordered_json json_of(const glm::dvec3& vector) {
    return {vector.x, vector.y, vector.z};
}

}  // namespace

glm::dvec3 direction_at(const JsonPlace& place) {
    constexpr double rounding = 1e-12;
    constexpr double largest_fault = 2e-3;
    const glm::dvec3 direction = vector_at(place);
    const double fault = std::abs(glm::dot(direction, direction) - 1);
    if (!(fault <= largest_fault)) place.fail_expecting("a vector of length 1");
    return fault < rounding ? direction : glm::normalize(direction);
}

LandmarkSet parse_landmarks(std::string_view text, std::string_view file) {
    const nlohmann::json document = parse_json(text, file);
    const JsonPlace root(document, std::string(file));
    const JsonPlace format = root.member("format");
    if (format.string() != format_name) format.fail_expecting(fmt::format("\"{}\"", format_name));
    const JsonPlace version = root.member("version");
    if (version.number() != format_version) version.fail_expecting(fmt::format("{}", format_version));
    LandmarkSet set;
    set.landmarks = landmarks_at(root.member("landmarks"));
    if (const auto symmetric = root.optional_member("symmetric"))
        set.symmetric = symmetric_at(*symmetric, set.landmarks);
    return set;
}

LandmarkSet read_landmarks(const std::filesystem::path& file) {
    return parse_landmarks(read_text(file, max_file_size), file.string());
}

std::string landmarks_text(const LandmarkSet& set) {
    const auto array = [](const std::vector<std::string>& elements) {
        return fmt::format("[\n    {}\n  ]", joined(elements, ",\n    "));
    };
    std::vector<std::string> landmarks;
    landmarks.reserve(set.landmarks.size());
    for (const Landmark& each : set.landmarks) {
        nlohmann::ordered_json landmark = {{"name", each.name}, {"position", json_of(each.position)}};
        if (each.direction) landmark["direction"] = json_of(*each.direction);
        landmarks.push_back(landmark.dump());
    }
    std::string text = fmt::format("{{\n  \"format\": \"{}\",\n  \"version\": {},\n  \"landmarks\": {}",
                                   format_name, format_version, array(landmarks));
    std::vector<std::string> pairs;
    pairs.reserve(set.symmetric.size());
    for (const auto& pair : set.symmetric) pairs.push_back(nlohmann::json(pair).dump());
    if (!pairs.empty()) text += fmt::format(",\n  \"symmetric\": {}", array(pairs));
    return text + "\n}\n";
}

}  // namespace interleaf
