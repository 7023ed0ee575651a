// The complex of all red splits: the triangles that 4-1 splits can make over a root complex, each made when
// first requested (paper, sections 1 and 2; Bank and Sherman 1981).
//
// Keys over the same roots share one complex, so a triangle, an edge and a vertex have the same number in all
// of them. A key is the set of triangles it splits (red_forest.h). The complex has no green triangles,
// because 4-1 splits do not make them.
//
// Corners 0 to 2 of a triangle are opposite its edges 0 to 2. The children 0 to 2 lie at these corners, and
// child 3 in the middle, with its corner c on edge c of its parent. So a child's edges are parallel to the
// edges of the same numbers in its parent, and the median from corner c to edge c continues as the median c
// of the children c and 3.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

#include "hierarchy/root_complex.h"
#include "hierarchy/triangle.h"

namespace interleaf::bench {

struct RedNode {
    Triangle vertices;
    std::array<Index, 3> edges;    ///< opposite the vertices
    Index first_child = no_index;  ///< the first of four; no_index until they are made
};

struct RedEdge {
    std::array<Index, 2> ends;
    Index midpoint = no_index;      ///< no_index until it is made
    std::array<Index, 2> halves{};  ///< at the two ends; made together with the midpoint
};

/// The position of a midpoint, from the positions of the ends of its edge.
using MiddlePoint = glm::dvec3 (*)(const glm::dvec3& a, const glm::dvec3& b);

class RedComplex {
  public:
    /// \param points  one per root vertex
    /// \param middle  places all other vertices
    RedComplex(const RootComplex& roots, std::vector<glm::dvec3> points, MiddlePoint middle);

    /// The roots are the first nodes.
    Index root_count() const { return root_count_; }
    Index root_vertex_count() const { return root_vertex_count_; }
    const RedNode& node(Index index) const { return nodes_[index]; }
    const RedEdge& edge(Index index) const { return edges_[index]; }
    const glm::dvec3& point(Index vertex) const { return points_[vertex]; }
    Index node_count() const { return static_cast<Index>(nodes_.size()); }

    /// The vertex in the middle of \p edge.
    Index midpoint(Index edge);

    /// The first of the four children of \p node.
    Index children(Index node);

  private:
    Index add_edge(Index a, Index b);
    Index half_at(Index edge, Index end) const;

    Index root_count_;
    Index root_vertex_count_;
    MiddlePoint middle_;
    std::vector<RedNode> nodes_;
    std::vector<RedEdge> edges_;
    std::vector<glm::dvec3> points_;
};

}  // namespace interleaf::bench
