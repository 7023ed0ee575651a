#include "hierarchy/nodes/node_index.h"

#include <algorithm>
#include <iterator>

#include <glm/mat3x3.hpp>

#include "hierarchy/level_map.h"

namespace interleaf {

namespace {

/// Where the node begins in its root, as a part of 2^64: the path with its first turn in the highest bit. So
/// the nodes of a level have equal parts of the root, in preorder.
std::uint64_t begin_of(const NodePath& node) {
    std::uint64_t bits = node.path;
    std::uint64_t reversed = 0;
    for (unsigned level = 0; level < node.level; ++level) {
        reversed |= (bits & 1) << (63 - level);
        bits >>= 1;
    }
    return reversed;
}

/// The part that a node of \p level has of its root; 0 for all of it.
std::uint64_t part_of(unsigned level) {
    return level == 0 ? 0 : std::uint64_t{1} << (64 - level);
}

SurfacePoint at_vertex(Index vertex) {
    return {{vertex, vertex, vertex}, {1, 0, 0}};
}

/// The child that has corner \p corner of its parent, and the number of that corner in the child.
struct CornerInChild {
    unsigned child;
    unsigned corner;
};
constexpr std::array<CornerInChild, 3> corner_in_child = {{{0, 2}, {1, 2}, {0, 1}}};

}  // namespace

glm::vec3 surface_position(const SurfacePoint& point, std::span<const glm::vec3> positions) {
    glm::dvec3 place(0);
    for (int corner = 0; corner < 3; ++corner)
        place += point.barycentric[corner] *
                 glm::dvec3(positions[point.vertices[static_cast<std::size_t>(corner)]]);
    return place;
}

Index vertex_at(const SurfacePoint& point) {
    for (unsigned corner = 0; corner < 3; ++corner)
        if (point.barycentric[static_cast<int>(corner)] == 1) return point.vertices.at(corner);
    return no_index;
}

NodeIndex::NodeIndex(const Hierarchy& hierarchy) : roots_(hierarchy.roots) {
    add_leaves(hierarchy.leaf_count());
    for (const Leaf& leaf : leaves_of(hierarchy)) add_leaf(leaf.vertices, leaf.level);
    root_begins_.push_back(static_cast<Index>(triangles_.size()));
}

NodeIndex::NodeIndex(const UnionMesh& mesh) : roots_(mesh.roots) {
    add_leaves(mesh.leaf_count());
    for (std::size_t leaf = 0; leaf < mesh.leaf_count(); ++leaf)
        add_leaf(mesh.triangles[leaf], mesh.tags[leaf].level());
    root_begins_.push_back(static_cast<Index>(triangles_.size()));
}

/// Makes room for \p count leaves.
void NodeIndex::add_leaves(std::size_t count) {
    root_begins_.reserve(roots_.triangle_count() + std::size_t{1});
    begins_.reserve(count);
    levels_.reserve(count);
    triangles_.reserve(count);
}

void NodeIndex::add_leaf(const Triangle& vertices, unsigned level) {
    if (next_begin_ == 0) root_begins_.push_back(static_cast<Index>(triangles_.size()));
    begins_.push_back(next_begin_);
    levels_.push_back(static_cast<std::uint8_t>(level));
    triangles_.push_back(vertices);
    next_begin_ += part_of(level);  // wraps to 0 at the end of a root
}

/// The leaf that contains the begin of the node.
std::size_t NodeIndex::leaf_at_begin(const NodePath& node) const {
    const auto first = begins_.begin() + static_cast<std::ptrdiff_t>(root_begins_[node.root]);
    const auto last = begins_.begin() + static_cast<std::ptrdiff_t>(root_begins_[node.root + 1]);
    const auto after = std::upper_bound(first, last, begin_of(node));
    return static_cast<std::size_t>(std::distance(begins_.begin(), after)) - 1;
}

NodeState NodeIndex::state(const NodePath& node) const {
    const unsigned level = levels_[leaf_at_begin(node)];
    if (level == node.level) return NodeState::leaf;
    return level > node.level ? NodeState::bisected : NodeState::inside_leaf;
}

LeafRange NodeIndex::leaves(const NodePath& node) const {
    const std::size_t first = leaf_at_begin(node);
    if (levels_[first] <= node.level) return {first, first + 1};
    const std::uint64_t end = begin_of(node) + part_of(node.level);
    const std::size_t root_end = root_begins_[node.root + 1];
    if (end == 0) return {first, root_end};
    const auto from = begins_.begin() + static_cast<std::ptrdiff_t>(first);
    const auto to = begins_.begin() + static_cast<std::ptrdiff_t>(root_end);
    const auto after = std::lower_bound(from, to, end);
    return {first, static_cast<std::size_t>(std::distance(begins_.begin(), after))};
}

Triangle NodeIndex::vertices(const NodePath& node) const {
    Triangle vertices{};
    for (unsigned corner = 0; corner < 3; ++corner) {
        NodePath at = node;
        unsigned place = corner;
        while (state(at) == NodeState::bisected) {
            at = child_of(at, corner_in_child.at(place).child);
            place = corner_in_child.at(place).corner;
        }
        vertices.at(corner) = triangles_[leaf_at_begin(at)].at(place);
    }
    return vertices;
}

std::array<SurfacePoint, 3> NodeIndex::corners(const NodePath& node) const {
    const std::size_t leaf = leaf_at_begin(node);
    const unsigned level = levels_[leaf];
    if (level >= node.level) {
        const auto [i, j, k] = vertices(node);
        return {at_vertex(i), at_vertex(j), at_vertex(k)};
    }
    const glm::dmat3 in_leaf = level_map(node.path >> level, node.level - level);
    return {{{triangles_[leaf], in_leaf[0]}, {triangles_[leaf], in_leaf[1]}, {triangles_[leaf], in_leaf[2]}}};
}

std::array<std::vector<SurfacePoint>, 3> NodeIndex::boundary(const NodePath& node) const {
    const std::array<SurfacePoint, 3> ends = corners(node);
    const bool is_inside = state(node) == NodeState::inside_leaf;
    std::array<std::vector<SurfacePoint>, 3> parts;
    for (unsigned side = 0; side < 3; ++side) {
        parts.at(side).push_back(ends.at((side + 1) % 3));
        if (is_inside)
            parts.at(side).push_back(ends.at((side + 2) % 3));
        else
            add_side({node, side}, parts.at(side));
    }
    return parts;
}

/// Adds the points after the begin of the side.
void NodeIndex::add_side(const NodeSide& side, std::vector<SurfacePoint>& points) const {
    if (state(side.node) != NodeState::bisected) {
        points.push_back(at_vertex(triangles_[leaf_at_begin(side.node)].at((side.side + 2) % 3)));
    } else if (side.side == refinement_side) {  // from j over l to k
        add_side({child_of(side.node, 1), half_side[1]}, points);
        add_side({child_of(side.node, 0), half_side[0]}, points);
    } else {
        add_side(child_with_side(side), points);
    }
}

}  // namespace interleaf
