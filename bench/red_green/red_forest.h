// A red forest: the triangles of a red complex that one key splits, with the rules that make its mesh
// conforming (Bank and Sherman 1981; Bank, Sherman and Weiser 1983).
//
// Red rule: a leaf with hanging vertices on two or three of its edges is split, and so is a leaf with more
// than one hanging vertex on an edge. Green rule: a leaf with one hanging vertex is drawn as two triangles,
// divided by the median to it. Green triangles are never split: where refinement goes on, the leaf is split
// red in their place. So the forest holds red splits alone, and the green lines follow from it.
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

    /// Whether \p vertex, not one of the roots', is a vertex of the forest.
    bool has_midpoint(Index vertex) const { return vertex < is_vertex_.size() && is_vertex_[vertex]; }

    /// Whether the middle of \p edge is a vertex of the forest.
    bool bisects(Index edge) const { return has_midpoint(complex_->edge(edge).midpoint); }

    /// The corner of \p leaf from which its green line goes to the hanging vertex; no_line when it has none.
    /// \pre the forest is closed
    unsigned green_line(Index leaf) const;

    void split(Index node);

    /// Splits what the red rule demands.
    void close();

    /// The nodes that are not split, root after root.
    std::vector<Index> leaves() const;

    /// Splits what \p other splits. The result need not be closed.
    void add(const RedForest& other);

  private:
    bool must_be_split(Index leaf) const;

    RedComplex* complex_;
    std::vector<bool> split_;
    std::vector<bool> is_vertex_;
};

/// The triangles of the conforming mesh of \p forest, green ones included.
std::vector<Triangle> mesh_of(const RedForest& forest);

/// The triangles as which \p leaf is drawn: itself, or the two beside the green line \p line.
std::vector<Triangle> triangles_of_leaf(const RedComplex& complex, Index leaf, unsigned line);

}  // namespace interleaf::bench
