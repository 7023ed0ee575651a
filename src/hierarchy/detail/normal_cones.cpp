#include "hierarchy/detail/normal_cones.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <glm/geometric.hpp>

#include "hierarchy/detail/bisected_nodes.h"

namespace interleaf {

namespace {

constexpr float all_around = std::numbers::pi_v<float>;

/// The cone of one leaf; none if it has no area.
std::optional<NormalCone> leaf_cone(const Hierarchy& hierarchy, const Triangle& leaf) {
    const auto& p = hierarchy.positions;
    const glm::dvec3 a = p[leaf[0]];
    const glm::dvec3 normal = glm::cross(glm::dvec3(p[leaf[1]]) - a, glm::dvec3(p[leaf[2]]) - a);
    const double length = glm::length(normal);
    if (!(length > 0)) return std::nullopt;
    return NormalCone{glm::vec3(normal / length), 0};
}

std::optional<NormalCone> united(const std::optional<NormalCone>& a, const std::optional<NormalCone>& b) {
    if (!a) return b;
    if (!b) return a;
    return cone_around(*a, *b);
}

}  // namespace

NormalCone cone_around(const NormalCone& a, const NormalCone& b) {
    const float between = std::acos(std::clamp(glm::dot(a.axis, b.axis), -1.0F, 1.0F));
    if (between + b.half_angle <= a.half_angle) return a;
    if (between + a.half_angle <= b.half_angle) return b;
    const float half_angle = (between + a.half_angle + b.half_angle) / 2;
    const float sine = std::sin(between);
    if (half_angle >= all_around || sine < 1e-6F) {
        if (between < 1)
            return {a.axis, std::min(between + std::max(a.half_angle, b.half_angle), all_around)};
        return {};
    }
    // The axis lies on the great circle through both axes.
    const float turn = half_angle - a.half_angle;
    const glm::vec3 axis = (std::sin(between - turn) * a.axis + std::sin(turn) * b.axis) / sine;
    return {glm::normalize(axis), half_angle};
}

std::vector<NormalCone> normal_cones(const Hierarchy& hierarchy, const BisectionForest& forest) {
    std::vector<std::optional<NormalCone>> cones(hierarchy.midpoints.size());
    for_each_bisected_node(hierarchy, [&](const BisectedNode& node) {
        const auto children = bisect(node.vertices, node.midpoint);
        for (std::size_t child = 0; child < 2; ++child)
            if (forest.bisections[node.place].children[child] == no_index)
                cones[node.place] = united(cones[node.place], leaf_cone(hierarchy, children[child]));
    });
    // Children come after their parents.
    for (std::size_t place = cones.size(); place-- > 0;)
        for (const Index child : forest.bisections[place].children)
            if (child != no_index) cones[place] = united(cones[place], cones[child]);
    std::vector<NormalCone> result;
    result.reserve(cones.size());
    for (const std::optional<NormalCone>& cone : cones) result.push_back(cone.value_or(NormalCone{}));
    return result;
}

}  // namespace interleaf
