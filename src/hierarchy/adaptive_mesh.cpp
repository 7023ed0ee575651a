#include "hierarchy/adaptive_mesh.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include <fmt/core.h>

namespace interleaf {

AdaptiveMesh::AdaptiveMesh(const RootComplex& roots, std::span<const glm::vec3> positions,
                           PlaceVertices place_vertices)
    : roots_(roots), positions_(positions), place_vertices_(std::move(place_vertices)) {
    assert(positions_.size() == roots_.vertex_count());
    const Index count = roots_.triangle_count();
    for (Index t = 0; t < count; ++t)
        leaves_.push_back(
            {roots_.triangles()[t], roots_.neighbors()[t], t + 1 < count ? t + 1 : no_index, 0, false, 0});
}

std::size_t AdaptiveMesh::byte_count() const {
    return leaves_.byte_count() + positions_.byte_count() + free_leaves_.byte_count() +
           free_vertices_.byte_count() + pending_.byte_count();
}

std::vector<Index> AdaptiveMesh::preorder() const {
    std::vector<Index> order;
    order.reserve(leaf_count());
    for (Index leaf = 0; leaf != no_index && order.size() < leaf_count(); leaf = leaves_[leaf].next)
        order.push_back(leaf);
    return order;
}

Hierarchy AdaptiveMesh::freeze(std::span<const Field> fields) const {
    std::vector<Leaf> leaves;
    leaves.reserve(leaf_count());
    for (const Index leaf : preorder()) leaves.push_back({leaves_[leaf].vertices, leaves_[leaf].level});
    return hierarchy_from_leaves(roots_, leaves, positions(), fields);
}

std::vector<std::string> AdaptiveMesh::violations() const {
    std::vector<std::string> found;
    if (const std::size_t listed = preorder().size(); listed != leaf_count())
        found.push_back(fmt::format("{} leaves are in preorder, expected {}", listed, leaf_count()));
    for (Index leaf = 0; leaf < leaf_bound(); ++leaf) {
        const LeafRecord& record = leaves_[leaf];
        if (record.is_flagged) found.push_back(fmt::format("leaf {} is flagged", leaf));
        if (!is_leaf(leaf)) continue;
        if (record.level > max_level)
            found.push_back(fmt::format("leaf {} has level {}", leaf, record.level));
        for (unsigned side = 0; side < 3; ++side) {
            const Index neighbor = record.neighbors[side];
            if (neighbor == no_index) continue;
            const LeafRecord& other = leaves_[neighbor];
            const auto back =
                std::find(other.neighbors.begin(), other.neighbors.end(), leaf) - other.neighbors.begin();
            if (back == 3) {
                found.push_back(
                    fmt::format("leaf {} has the neighbor {}, which does not have it", leaf, neighbor));
                continue;
            }
            const auto corner = static_cast<std::size_t>(back);
            if (other.vertices[(corner + 1) % 3] != record.vertices[(side + 2) % 3] ||
                other.vertices[(corner + 2) % 3] != record.vertices[(side + 1) % 3])
                found.push_back(
                    fmt::format("leaf {} and its neighbor {} share no edge there", leaf, neighbor));
        }
    }
    return found;
}

}  // namespace interleaf
