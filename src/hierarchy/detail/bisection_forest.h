// The bisections of a hierarchy as a forest with random access: what a refinement of the hierarchy from its
// roots reads, in any order.
#pragma once

#include <array>
#include <vector>

#include "hierarchy/hierarchy.h"
#include "hierarchy/triangle.h"

namespace interleaf {

/// A bisected triangle: the vertices and triangles that bisecting it involves.
struct Bisection {
    Index midpoint = no_index;
    Index newest = no_index;                               ///< the vertex that must exist before
    std::array<Index, 2> children = {no_index, no_index};  ///< places of the children that are bisected, too
};

/// The bisections of a hierarchy, by their places in Hierarchy::midpoints.
struct BisectionForest {
    std::vector<Bisection> bisections{};
    std::vector<Index> roots{};  ///< by root: its place; no_index if it is a leaf
    std::vector<std::array<Index, 2>>
        at{};  ///< by vertex: the bisections that have it as their midpoint; the second is no_index on a boundary
};

/// \pre  the hierarchy passes check()
BisectionForest bisection_forest(const Hierarchy& hierarchy);

}  // namespace interleaf
