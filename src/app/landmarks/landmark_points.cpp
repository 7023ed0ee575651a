#include "app/landmarks/landmark_points.h"

#include <algorithm>
#include <utility>

#include <fmt/core.h>
#include <glm/geometric.hpp>

#include "text/characters.h"

namespace interleaf {

bool is_paired(const LandmarkPoint& point, std::size_t mesh) {
    if (mesh > 0) return point.places[0] && point.places[mesh];
    return point.places[0] && std::any_of(point.places.begin() + 1, point.places.end(),
                                          [](const auto& place) { return place.has_value(); });
}

std::vector<Landmark> counting_landmarks(const LandmarkPoints& points, std::size_t mesh) {
    std::vector<Landmark> landmarks;
    for (const LandmarkPoint& point : points)
        if (is_paired(point, mesh)) landmarks.push_back({point.name, *point.places[mesh]});
    return landmarks;
}

void put_landmarks(LandmarkPoints& points, std::size_t mesh_count, std::size_t mesh,
                   const std::vector<Landmark>& landmarks) {
    for (const Landmark& landmark : landmarks) {
        auto point = std::ranges::find(points, landmark.name, &LandmarkPoint::name);
        if (point == points.end()) {
            points.push_back({.name = landmark.name, .places = {}});
            point = points.end() - 1;
            point->places.resize(mesh_count);
        }
        if (mesh > 0 || !point->direction) point->places[mesh] = landmark.position;
    }
}

std::vector<Landmark> landmarks_on(const LandmarkPoints& points, std::size_t mesh) {
    std::vector<Landmark> landmarks;
    for (const LandmarkPoint& point : points)
        if (point.places[mesh]) landmarks.push_back({point.name, *point.places[mesh]});
    return landmarks;
}

std::string free_name(const LandmarkPoints& points) {
    for (std::size_t number = 1;; ++number) {
        std::string name = fmt::format("{}", number);
        if (std::ranges::find(points, name, &LandmarkPoint::name) == points.end()) return name;
    }
}

std::size_t add_place(LandmarkPoints& points, std::size_t mesh_count, std::size_t mesh,
                      const glm::dvec3& place, std::optional<std::size_t> selected) {
    const auto lacks_place = [&](const LandmarkPoint& point) {
        return !point.places[mesh] &&
               std::ranges::any_of(point.places, [](const auto& at) { return at.has_value(); });
    };
    std::size_t index = points.size();
    if (selected && *selected < points.size() && lacks_place(points[*selected])) {
        index = *selected;
    } else {
        const auto last = std::find_if(points.rbegin(), points.rend(), lacks_place);
        if (last != points.rend()) index = static_cast<std::size_t>(points.rend() - last) - 1;
    }
    if (index == points.size()) {
        LandmarkPoint added{.name = free_name(points), .places = {}};
        added.places.resize(mesh_count);
        points.push_back(std::move(added));
    }
    points[index].places[mesh] = place;
    return index;
}

std::string fault_of_name(const LandmarkPoints& points, std::size_t index, const std::string& name) {
    if (name.empty() || !is_printable(name))
        return "A name has at least one character, and no control characters";
    const auto same = std::ranges::find(points, name, &LandmarkPoint::name);
    if (same != points.end() && static_cast<std::size_t>(same - points.begin()) != index)
        return "Another landmark has this name";
    return "";
}

std::vector<std::array<std::size_t, 2>> mirror_pairs(const std::vector<glm::dvec3>& places) {
    constexpr double tolerance = 0.12;  // of the largest distance
    double size = 0;
    for (const glm::dvec3& a : places)
        for (const glm::dvec3& b : places) size = std::max(size, glm::distance(a, b));
    std::vector<std::array<std::size_t, 2>> best;
    std::size_t best_count = 2;  // a plane that mirrors only the two that define it says nothing
    double least_error = 0;
    for (std::size_t i = 0; i < places.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) {
            const glm::dvec3 way = places[i] - places[j];
            if (!(glm::length(way) > tolerance * size)) continue;
            const glm::dvec3 normal = glm::normalize(way);
            const double offset = glm::dot(normal, places[i] + places[j]) / 2;
            std::vector<std::array<std::size_t, 2>> pairs;
            std::size_t count = 0;
            double error = 0;
            for (std::size_t k = 0; k < places.size(); ++k) {
                const glm::dvec3 mirrored = places[k] - 2 * (glm::dot(normal, places[k]) - offset) * normal;
                const auto nearest = std::ranges::min_element(
                    places, {}, [&](const glm::dvec3& place) { return glm::distance(place, mirrored); });
                const double off = glm::distance(*nearest, mirrored);
                if (off > tolerance * size) continue;
                ++count;
                error += off;
                const auto other = static_cast<std::size_t>(nearest - places.begin());
                if (k < other) pairs.push_back({k, other});
            }
            if (count < best_count || (count == best_count && (best.empty() || error >= least_error)) ||
                count < 3)
                continue;
            best_count = count;
            least_error = error;
            best = std::move(pairs);
        }
    std::vector<char> used(places.size(), 0);
    std::erase_if(best, [&](const std::array<std::size_t, 2>& pair) {
        return std::exchange(used[pair[0]], char{1}) != 0 || std::exchange(used[pair[1]], char{1}) != 0;
    });
    return best;
}

bool swap_sides(LandmarkPoints& points, std::size_t mesh) {
    std::vector<std::size_t> paired;
    std::vector<glm::dvec3> places;
    for (std::size_t k = 0; k < points.size(); ++k) {
        if (!is_paired(points[k], mesh)) continue;
        paired.push_back(k);
        places.push_back(*points[k].places[0]);
    }
    const auto pairs = mirror_pairs(places);
    for (const auto& [left, right] : pairs)
        std::swap(points[paired[left]].places[mesh], points[paired[right]].places[mesh]);
    return !pairs.empty();
}

void LandmarkHistory::push(LandmarkPoints points) {
    if (points == states_[present_]) return;
    states_.resize(present_ + 1);
    states_.push_back(std::move(points));
    ++present_;
}

}  // namespace interleaf
