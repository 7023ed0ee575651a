// Random access to the nodes of a triangulation by their paths. A hierarchy and a union are streams in preorder;
// this index finds the leaves of any node in logarithmic time. It is made in linear time, and takes 21 bytes per
// leaf.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "hierarchy/hierarchy.h"
#include "hierarchy/nodes/node_path.h"
#include "hierarchy/root_complex.h"
#include "hierarchy/triangle.h"
#include "hierarchy/union_mesh.h"

namespace interleaf {

/// What a hierarchy has at a node of the infinite forest.
enum class NodeState : std::uint8_t {
    inside_leaf,  ///< no node: the hierarchy does not bisect this far
    leaf,
    bisected,
};

/// A point of a triangulation: the mean of three vertices with these weights.
struct SurfacePoint {
    Triangle vertices;
    glm::dvec3 barycentric;  ///< in the triangle of \p vertices; sums to 1
};

/// The place of \p point where the vertices have \p positions.
glm::vec3 surface_position(const SurfacePoint& point, std::span<const glm::vec3> positions);

/// The vertex that \p point is; no_index if it is none.
Index vertex_at(const SurfacePoint& point);

/// Leaves begin to end - 1, in preorder.
struct LeafRange {
    std::size_t begin = 0;
    std::size_t end = 0;
    std::size_t count() const { return end - begin; }
    bool operator==(const LeafRange&) const = default;
};

class NodeIndex {
  public:
    explicit NodeIndex(const Hierarchy& hierarchy);
    explicit NodeIndex(const UnionMesh& mesh);

    const RootComplex& roots() const { return roots_; }
    std::size_t leaf_count() const { return triangles_.size(); }

    /// The functions with a node require that its root exists.

    NodeState state(const NodePath& node) const;

    /// The leaves that the node consists of, or the one that it is or lies in.
    LeafRange leaves(const NodePath& node) const;

    unsigned level(std::size_t leaf) const { return levels_[leaf]; }

    /// \pre state(node) is not inside_leaf
    Triangle vertices(const NodePath& node) const;

    /// The three corners, also inside of a leaf, where the level maps give their places.
    std::array<SurfacePoint, 3> corners(const NodePath& node) const;

    /// The boundary along the leaves, from corner to corner in the order of the vertices: part n goes along the
    /// side opposite corner n and has both its ends. Each is straight between two neighbors.
    std::array<std::vector<SurfacePoint>, 3> boundary(const NodePath& node) const;

  private:
    void add_leaves(std::size_t count);
    void add_leaf(const Triangle& vertices, unsigned level);
    std::size_t leaf_at_begin(const NodePath& node) const;
    void add_side(const NodeSide& side, std::vector<SurfacePoint>& points) const;

    RootComplex roots_;
    std::vector<Index> root_begins_;     ///< first leaf of each root, and the number of leaves
    std::vector<std::uint64_t> begins_;  ///< per leaf: where it begins in its root, as a part of 2^64
    std::vector<std::uint8_t> levels_;
    std::vector<Triangle> triangles_;
    std::uint64_t next_begin_ = 0;
};

}  // namespace interleaf
