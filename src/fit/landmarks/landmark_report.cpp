#include "fit/landmarks/landmark_report.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include <fmt/core.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "hierarchy/union_mesh.h"
#include "text/shown_text.h"

namespace interleaf {
namespace {

/// Right landmarks of four-legged animals come to 2.4 at most.
constexpr double unusual_distortion = 3;

/// Of the corners of a spherical triangle, or their places in space.
using Corners = std::array<glm::dvec3, 3>;

/// The coordinates of \p direction in the cone of three unit vectors; none negative if it lies in the cone.
glm::dvec3 coordinates_in_cone(const Corners& corners, const glm::dvec3& direction) {
    const auto& [a, b, c] = corners;
    const glm::dvec3 volumes(glm::dot(direction, glm::cross(b, c)), glm::dot(direction, glm::cross(c, a)),
                             glm::dot(direction, glm::cross(a, b)));
    return volumes / glm::dot(a, glm::cross(b, c));
}

double least_of(const glm::dvec3& values) {
    return std::min({values.x, values.y, values.z});
}

/// Goes through the nodes of a key in preorder.
class NodeCursor {
  public:
    explicit NodeCursor(const Hierarchy& key) : key_(key) {}

    /// The midpoint of the present node, or no_index for a leaf. Goes on to the next node.
    Index next() { return key_.is_bisected(node_++) ? key_.midpoints[midpoint_++] : no_index; }

    /// Passes the present node and all below it.
    void skip() {
        for (std::size_t open = 1; open > 0;) open = next() == no_index ? open - 1 : open + 1;
    }

  private:
    const Hierarchy& key_;
    std::size_t node_ = 0;
    std::size_t midpoint_ = 0;
};

Corners corners_of(const SphereRoots& roots, Index root) {
    const auto& [a, b, c] = roots.complex.triangles()[root];
    return {roots.points[a], roots.points[b], roots.points[c]};
}

Index root_in_direction(const SphereRoots& roots, const glm::dvec3& direction) {
    Index best = 0;
    double largest = -std::numeric_limits<double>::infinity();
    for (Index root = 0; root < roots.complex.triangle_count(); ++root) {
        const double least = least_of(coordinates_in_cone(corners_of(roots, root), direction));
        if (least <= largest) continue;
        largest = least;
        best = root;
    }
    return best;
}

/// The conformal distortion of the linear map from triangle \p from to triangle \p to.
double distortion_of(const Corners& from, const Corners& to) {
    double sum = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        const glm::dvec3 u = from[(k + 1) % 3] - from[k];
        const glm::dvec3 v = from[(k + 2) % 3] - from[k];
        const glm::dvec3 across = to[(k + 2) % 3] - to[(k + 1) % 3];
        sum += glm::dot(u, v) / glm::length(glm::cross(u, v)) * glm::dot(across, across);
    }
    return sum / (2 * glm::length(glm::cross(to[1] - to[0], to[2] - to[0])));
}

std::size_t nearest_of(std::span<const glm::dvec3> points, const glm::dvec3& place) {
    const auto distance = [&](const glm::dvec3& point) { return glm::distance(point, place); };
    return std::size_t(std::ranges::min_element(points, {}, distance) - points.begin());
}

}  // namespace

std::vector<Landmark> targets_of(std::span<const FittedLandmark> landmarks) {
    std::vector<Landmark> targets;
    targets.reserve(landmarks.size());
    for (const FittedLandmark& each : landmarks)
        targets.push_back({each.name, each.position, each.direction});
    return targets;
}

glm::dvec3 point_in_direction(const Hierarchy& key, const SphereRoots& roots, const glm::dvec3& direction) {
    const Index root = root_in_direction(roots, direction);
    NodeCursor cursor(key);
    for (Index before = 0; before < root; ++before) cursor.skip();
    Triangle node = roots.complex.triangles()[root];
    Corners corners = corners_of(roots, root);
    for (Index midpoint = cursor.next(); midpoint != no_index; midpoint = cursor.next()) {
        const auto [i, j, k] = corners;
        const glm::dvec3 middle = glm::normalize(j + k);
        const bool is_in_first = glm::dot(direction, glm::cross(i, middle)) > 0;  // beside k
        if (!is_in_first) cursor.skip();
        node = bisect(node, midpoint)[is_in_first ? 0 : 1];
        corners = is_in_first ? Corners{middle, k, i} : Corners{middle, i, j};
    }
    glm::dvec3 place = glm::max(coordinates_in_cone(corners, direction), glm::dvec3(0));
    place /= place.x + place.y + place.z;
    return place.x * glm::dvec3(key.positions[node[0]]) + place.y * glm::dvec3(key.positions[node[1]]) +
           place.z * glm::dvec3(key.positions[node[2]]);
}

std::vector<glm::dvec3> sphere_points_of(const Hierarchy& key, const SphereRoots& roots) {
    std::vector<glm::dvec3> points(key.positions.size());
    std::ranges::copy(roots.points, points.begin());
    NodeCursor cursor(key);
    std::vector<Triangle> open;
    for (const Triangle& root : roots.complex.triangles()) {
        open.push_back(root);
        while (!open.empty()) {
            const Triangle node = open.back();
            open.pop_back();
            const Index midpoint = cursor.next();
            if (midpoint == no_index) continue;
            points[midpoint] = glm::normalize(points[node[1]] + points[node[2]]);
            const auto [first, second] = bisect(node, midpoint);
            open.push_back(second);
            open.push_back(first);
        }
    }
    return points;
}

MorphDistortion morph_distortion(const Hierarchy& first, const Hierarchy& other,
                                 std::span<const glm::dvec3> landmarks) {
    const std::array<const Hierarchy*, 2> keys = {&first, &other};
    const UnionMesh mesh = unite(keys);
    std::vector<std::pair<double, double>> distortions;  // with the triangle's area in the first key
    std::vector<double> distorted_area(landmarks.size());
    double whole = 0;
    for (const Triangle& triangle : mesh.triangles) {
        Corners from;
        Corners to;
        for (std::size_t k = 0; k < 3; ++k) {
            from[k] = mesh.positions[0][triangle[k]];
            to[k] = mesh.positions[1][triangle[k]];
        }
        const double area = glm::length(glm::cross(from[1] - from[0], from[2] - from[0]));
        if (!(area > 0)) continue;
        double distortion = distortion_of(from, to);
        if (!(distortion < std::numeric_limits<double>::max()))
            distortion = std::numeric_limits<double>::max();
        distortions.emplace_back(distortion, area);
        whole += area;
        if (distortion > unusual_distortion)
            distorted_area[nearest_of(landmarks, (from[0] + from[1] + from[2]) / 3.0)] += area;
    }
    std::ranges::sort(distortions);
    MorphDistortion found;
    double sum = 0;
    for (const auto& [distortion, area] : distortions) {
        found.at_90_percent = distortion;
        sum += area;
        if (sum >= 0.9 * whole) break;
    }
    found.worst = std::size_t(std::ranges::max_element(distorted_area) - distorted_area.begin());
    return found;
}

std::string fault_of_distortion(const MorphDistortion& distortion, const std::string& name) {
    if (distortion.at_90_percent <= unusual_distortion) return {};
    return fmt::format(
        "a tenth of the surface is distorted more than {:.3g} times against the first mesh, most of all "
        "around "
        "the landmark '{}': check it",
        distortion.at_90_percent, shown_text(name));
}

}  // namespace interleaf
