// A red forest: the triangles of a red complex that one key splits, with the rules that make its mesh
// conforming (Bank and Sherman 1981; Bank, Sherman and Weiser 1983).
//
// Red rule: a leaf is split if it has hanging vertices on two or three of its edges, or more than one hanging
// vertex on an edge. Green rule: a leaf with one hanging vertex is drawn as two triangles, divided by the
// median to that vertex. Green triangles are never split: if refinement continues, the leaf is split red
// instead. So the forest holds red splits only, and they determine the green lines.
#pragma once

#include <cstddef>
#include <vector>

#include "red_complex.h"

namespace interleaf::bench {

/// No green line: a leaf without hanging vertices.
inline constexpr unsigned no_line = 3;

class RedForest {
  public:
    explicit RedForest(RedComplex& complex) : complex_(&complex) {}

    RedComplex& complex() const { return *complex_; }

    bool is_split(Index node) const { return node < split_.size() && split_[node]; }

    /// Whether \p vertex, which is no root vertex, is a vertex of the forest.
    bool has_midpoint(Index vertex) const { return vertex < is_vertex_.size() && is_vertex_[vertex]; }

    /// Whether the middle of \p edge is a vertex of the forest.
    bool bisects(Index edge) const { return has_midpoint(complex_->edge(edge).midpoint); }

    /// The corner of \p leaf where the green line to the hanging vertex begins; no_line if there is none.
    /// \pre  the forest is closed
    unsigned green_line(Index leaf) const;

    void split(Index node);

    /// Splits the leaves that the red rule demands to split.
    void close();

    /// The nodes that are not split, root after root.
    std::vector<Index> leaves() const;

    /// Splits all nodes that \p other splits. The result need not be closed.
    void add(const RedForest& other);

  private:
    bool must_be_split(Index leaf) const;

    RedComplex* complex_;
    std::vector<bool> split_;
    std::vector<bool> is_vertex_;
};

/// The triangles of the conforming mesh of \p forest, including green ones.
std::vector<Triangle> mesh_of(const RedForest& forest);

/// The triangles that \p leaf is drawn as: the leaf itself, or the two beside the green line \p line.
std::vector<Triangle> triangles_of_leaf(const RedComplex& complex, Index leaf, unsigned line);

}  // namespace interleaf::bench
