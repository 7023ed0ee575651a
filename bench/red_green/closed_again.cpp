#include "closed_again.h"

#include <algorithm>
#include <array>

#include "key_over_node.h"
#include <glm/geometric.hpp>

namespace interleaf::bench {
namespace {

/// Upper bound of the distance between \p key and the leaf's own triangles, which \p line divides and which
/// have the key's values at their vertices. The difference is linear between the corners, the midpoints of
/// the edges and the centroid, and zero at the corners and at the end of the line.
double loss_in_leaf(const RedGreenKey& key, const KeyOverNode& over, unsigned line) {
    const auto at = [&](const glm::dvec3& b) { return point_over(key, over, b); };
    std::array<glm::dvec3, 3> corner_points;
    std::array<glm::dvec3, 3> middles;
    for (unsigned c = 0; c < 3; ++c) {
        glm::dvec3 corner(0);
        corner[static_cast<int>(c)] = 1;
        corner_points[c] = at(corner);
        middles[c] = at(0.5 * (glm::dvec3(1) - corner));
    }
    double loss = 0;
    glm::dvec3 centroid = (corner_points[0] + corner_points[1] + corner_points[2]) / 3.0;
    for (unsigned c = 0; c < 3; ++c) {
        if (c == line)
            centroid = (corner_points[c] + 2.0 * middles[c]) / 3.0;
        else
            loss = std::max(loss, glm::distance(middles[c], 0.5 * (corner_points[(c + 1) % 3] +
                                                                   corner_points[(c + 2) % 3])));
    }
    return std::max(loss, glm::distance(centroid, at(glm::dvec3(1.0 / 3))));
}

std::size_t split_count(const RedForest& forest) {
    // Each split replaces one leaf by four.
    return (forest.leaves().size() - forest.complex().root_count()) / 3;
}

}  // namespace

ClosedAgain closed_again(std::span<const RedGreenKey> keys) {
    ClosedAgain result{RedForest(keys.front().forest.complex()), 0, 0, 0, {}};
    for (const RedGreenKey& key : keys) result.forest.add(key.forest);
    const std::size_t united = split_count(result.forest);
    result.forest.close();
    result.added_splits = split_count(result.forest) - united;
    result.triangles = mesh_of(result.forest).size();
    result.max_loss.resize(keys.size());
    visit_nodes(result.forest, keys, [&](Index node, std::span<const KeyOverNode> over) {
        if (result.forest.is_split(node)) return;
        const unsigned line = result.forest.green_line(node);
        bool is_lost = false;
        for (std::size_t key = 0; key < keys.size(); ++key) {
            if (!over[key].is_cut() || over[key].line == line) continue;
            is_lost = true;
            double& largest = result.max_loss[key];
            largest = std::max(largest, loss_in_leaf(keys[key], over[key], line));
        }
        if (is_lost) ++result.leaves_with_loss;
    });
    return result;
}

}  // namespace interleaf::bench
