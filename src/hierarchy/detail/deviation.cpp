#include "hierarchy/detail/deviation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "hierarchy/detail/bisected_nodes.h"

namespace interleaf {

namespace {

/// The triangle of a bisected node in space, with all that its distance from a point takes.
class NodeTriangle {
  public:
    NodeTriangle() = default;
    explicit NodeTriangle(const std::array<glm::dvec3, 3>& corners) : corners_(corners) {
        for (std::size_t k = 0; k < 3; ++k) {
            edges_[k] = corners[(k + 2) % 3] - corners[(k + 1) % 3];
            squared_lengths_[k] = glm::dot(edges_[k], edges_[k]);
        }
        normal_ = glm::cross(edges_[0], edges_[1]);
        squared_normal_ = glm::dot(normal_, normal_);
        for (std::size_t k = 0; k < 3; ++k) inward_[k] = glm::cross(normal_, edges_[k]);
    }

    /// The squared distance of \p point from the edge opposite corner \p k.
    double squared_distance_to_edge(std::size_t k, const glm::dvec3& point) const {
        const glm::dvec3 from_begin = point - corners_[(k + 1) % 3];
        const double along = glm::dot(from_begin, edges_[k]);
        if (!(along > 0)) return glm::dot(from_begin, from_begin);
        const glm::dvec3 rest = from_begin - std::min(along / squared_lengths_[k], 1.0) * edges_[k];
        return glm::dot(rest, rest);
    }

    /// The squared distance of \p point from the triangle, which may be degenerate.
    double squared_distance(const glm::dvec3& point) const {
        bool is_above = squared_normal_ > 0;
        for (std::size_t k = 0; k < 3; ++k)
            is_above = is_above && glm::dot(inward_[k], point - corners_[(k + 1) % 3]) >= 0;
        if (is_above) {
            const double height = glm::dot(normal_, point - corners_[0]);
            return height * height / squared_normal_;
        }
        return std::min({squared_distance_to_edge(0, point), squared_distance_to_edge(1, point),
                         squared_distance_to_edge(2, point)});
    }

  private:
    std::array<glm::dvec3, 3> corners_{};
    std::array<glm::dvec3, 3> edges_{};   ///< each opposite the corner of the same number
    std::array<glm::dvec3, 3> inward_{};  ///< normal to each edge, in the triangle's plane
    std::array<double, 3> squared_lengths_{};
    glm::dvec3 normal_{0};
    double squared_normal_ = 0;
};

constexpr unsigned no_side = 3;

/// The side of the parent on which side \p side of child \p child lies; no_side if it lies inside.
constexpr unsigned side_of_parent(unsigned child, unsigned side) {
    if (side == sibling_side[child]) return no_side;
    return side == half_side[child] ? refinement_side : child + 1;
}

/// The least float that is not below \p value.
float rounded_up(double value) {
    const auto rounded = static_cast<float>(value);
    return static_cast<double>(rounded) < value
               ? std::nextafter(rounded, std::numeric_limits<float>::infinity())
               : rounded;
}

}  // namespace

std::vector<float> deviations(const Hierarchy& hierarchy, const DetailProgress& progress) {
    constexpr Index nodes_between_reports = 1 << 13;
    struct Ancestor {
        NodeTriangle triangle;
        Index place;
        unsigned child;
    };
    std::array<Ancestor, max_level> path;  // the present node and the nodes above it, by level
    std::vector<double> squared(hierarchy.midpoints.size(), 0.0);
    for_each_bisected_node(hierarchy, [&](const BisectedNode& node) {
        if (progress && node.place % nodes_between_reports == 0)
            progress(static_cast<double>(node.place) / static_cast<double>(hierarchy.midpoints.size()));
        const auto [i, j, k] = node.vertices;
        const auto& p = hierarchy.positions;
        path[node.level] = {NodeTriangle({p[i], p[j], p[k]}), node.place, node.child};
        const glm::dvec3 point = p[node.midpoint];
        // Where the midpoint lies inside an ancestor, both its visits are below that ancestor, and one of
        // them suffices.
        unsigned side = refinement_side;
        for (unsigned level = node.level; side != no_side || node.is_first_visit; --level) {
            const auto& [triangle, place, child] = path[level];
            const double distance = side == no_side ? triangle.squared_distance(point)
                                                    : triangle.squared_distance_to_edge(side, point);
            squared[place] = std::max(squared[place], distance);
            if (level == 0) break;
            if (side != no_side) side = side_of_parent(child, side);
        }
    });
    std::vector<float> result(squared.size());
    std::ranges::transform(squared, result.begin(),
                           [](double value) { return rounded_up(std::sqrt(value)); });
    return result;
}

}  // namespace interleaf
