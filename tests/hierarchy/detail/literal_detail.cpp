#include "hierarchy/detail/literal_detail.h"

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <optional>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace interleaf::testing {

namespace {

/// A node of the forest with pointers, as a textbook has it.
struct ForestNode {
    Triangle vertices{};
    std::optional<std::size_t> place;  ///< in Hierarchy::midpoints, if it is bisected
    std::vector<ForestNode> children;
};

struct Cursor {
    std::size_t position = 0;
    std::size_t place = 0;
};

ForestNode forest_node(const Hierarchy& hierarchy, const Triangle& vertices, Cursor& cursor) {
    ForestNode node{vertices, {}, {}};
    if (!hierarchy.is_bisected(cursor.position++)) return node;
    node.place = cursor.place++;
    for (const Triangle& child : bisect(vertices, hierarchy.midpoints[*node.place]))
        node.children.push_back(forest_node(hierarchy, child, cursor));
    return node;
}

std::vector<ForestNode> forest(const Hierarchy& hierarchy) {
    std::vector<ForestNode> roots;
    Cursor cursor;
    for (const Triangle& root : hierarchy.roots.triangles())
        roots.push_back(forest_node(hierarchy, root, cursor));
    return roots;
}

double distance_from_segment(const glm::dvec3& point, const glm::dvec3& a, const glm::dvec3& b) {
    const double squared = glm::dot(b - a, b - a);
    const double t = squared > 0 ? glm::clamp(glm::dot(point - a, b - a) / squared, 0.0, 1.0) : 0;
    return glm::distance(point, glm::mix(a, b, t));
}

/// The largest deviation of the vertices below \p node from the triangle of \p corners.
/// \param coordinates  barycentric coordinates in that triangle of the corners of \p node
double deviation_below(const Hierarchy& hierarchy, const ForestNode& node,
                       const std::array<glm::dvec3, 3>& corners,
                       const std::array<glm::dvec3, 3>& coordinates) {
    if (!node.place) return 0;
    const auto& [i, j, k] = coordinates;
    const glm::dvec3 middle = (j + k) / 2.0;
    const glm::dvec3 point = hierarchy.positions[hierarchy.midpoints[*node.place]];
    double deviation = literal_distance(point, corners[0], corners[1], corners[2]);
    for (int c = 0; c < 3; ++c)
        if (middle[c] == 0)
            deviation = distance_from_segment(point, corners[(static_cast<std::size_t>(c) + 1) % 3],
                                              corners[(static_cast<std::size_t>(c) + 2) % 3]);
    return std::max({deviation, deviation_below(hierarchy, node.children[0], corners, {middle, k, i}),
                     deviation_below(hierarchy, node.children[1], corners, {middle, i, j})});
}

void add_deviations(const Hierarchy& hierarchy, const ForestNode& node, std::vector<double>& result) {
    if (!node.place) return;
    const auto& [i, j, k] = node.vertices;
    const std::array<glm::dvec3, 3> corners = {hierarchy.positions[i], hierarchy.positions[j],
                                               hierarchy.positions[k]};
    result[*node.place] =
        deviation_below(hierarchy, node, corners, {glm::dvec3(1, 0, 0), {0, 1, 0}, {0, 0, 1}});
    for (const ForestNode& child : node.children) add_deviations(hierarchy, child, result);
}

}  // namespace

double literal_distance(const glm::dvec3& point, const glm::dvec3& a, const glm::dvec3& b,
                        const glm::dvec3& c) {
    double distance = std::min({distance_from_segment(point, a, b), distance_from_segment(point, b, c),
                                distance_from_segment(point, c, a)});
    // The nearest point of the plane, by the normal equations.
    const glm::dvec3 e = b - a, f = c - a, p = point - a;
    const double ee = glm::dot(e, e), ef = glm::dot(e, f), ff = glm::dot(f, f);
    const double determinant = ee * ff - ef * ef;
    if (determinant <= 1e-14 * ee * ff) return distance;
    const double s = (glm::dot(p, e) * ff - glm::dot(p, f) * ef) / determinant;
    const double t = (glm::dot(p, f) * ee - glm::dot(p, e) * ef) / determinant;
    if (s >= 0 && t >= 0 && s + t <= 1) distance = std::min(distance, glm::length(p - s * e - t * f));
    return distance;
}

std::vector<double> literal_deviations(const Hierarchy& hierarchy) {
    std::vector<double> result(hierarchy.midpoints.size());
    for (const ForestNode& root : forest(hierarchy)) add_deviations(hierarchy, root, result);
    return result;
}

std::vector<float> literal_errors(const Hierarchy& hierarchy, const std::vector<float>& deviations) {
    std::vector<float> errors(hierarchy.vertex_count(), -1);
    std::fill_n(errors.begin(), hierarchy.roots.vertex_count(), std::numeric_limits<float>::infinity());
    const std::vector<ForestNode> roots = forest(hierarchy);
    std::vector<const ForestNode*> leaves;  // those that the whole hierarchy bisects
    const auto add = [&](const ForestNode& node) {
        if (node.place) leaves.push_back(&node);
    };
    for (const ForestNode& root : roots) add(root);
    const auto bisect_leaf = [&](std::size_t n, float error) {
        const ForestNode& node = *leaves[n];
        leaves.erase(leaves.begin() + static_cast<std::ptrdiff_t>(n));
        const Index midpoint = hierarchy.midpoints[*node.place];
        if (errors[midpoint] < 0) errors[midpoint] = error;
        for (const ForestNode& child : node.children) add(child);
    };
    // Whether an edge of the leaf, not only its refinement edge, has a vertex in the middle: Algorithm (A)
    // bisects such a leaf.
    std::map<std::pair<Index, Index>, Index> middle_of;
    const auto collect = [&](const auto& self, const ForestNode& node) -> void {
        if (!node.place) return;
        middle_of[std::minmax(node.vertices[1], node.vertices[2])] = hierarchy.midpoints[*node.place];
        for (const ForestNode& child : node.children) self(self, child);
    };
    for (const ForestNode& root : roots) collect(collect, root);
    const auto hangs = [&](const ForestNode* node) {
        for (std::size_t c = 0; c < 3; ++c) {
            const auto found =
                middle_of.find(std::minmax(node->vertices[(c + 1) % 3], node->vertices[(c + 2) % 3]));
            if (found != middle_of.end() && errors[found->second] >= 0) return true;
        }
        return false;
    };
    float reached = std::numeric_limits<float>::infinity();
    while (!leaves.empty()) {
        const auto largest = std::ranges::max_element(
            leaves, {}, [&](const ForestNode* node) { return deviations[*node->place]; });
        reached = std::min(reached, deviations[*(*largest)->place]);
        bisect_leaf(static_cast<std::size_t>(largest - leaves.begin()), reached);
        for (auto hanging = std::ranges::find_if(leaves, hangs); hanging != leaves.end();
             hanging = std::ranges::find_if(leaves, hangs))
            bisect_leaf(static_cast<std::size_t>(hanging - leaves.begin()), reached);
    }
    return errors;
}

}  // namespace interleaf::testing
