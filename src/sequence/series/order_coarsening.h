// Finds the hierarchy above the triangles of one step from the order of corners and triangles alone, wherever
// the vertices are (Chen and Zhang 2010, "A coarsening algorithm on adaptive grids by newest vertex
// bisection").
//
// A vertex is good if it is the newest vertex of all its triangles, and these are four around it or two at the
// boundary. The triangles around a good vertex are halves of one or two triangles. The halves become their
// parent until no vertex is good.
#pragma once

#include <optional>
#include <vector>

#include "hierarchy/hierarchy.h"
#include "sequence/series/step_mesh.h"

namespace interleaf {

/// How a program writes triangles.
struct OrderRule {
    /// The corner of a triangle that is its newest vertex, 0 to 2.
    unsigned newest = 0;

    /// Whether the triangle with the lowest number around a good vertex is the second child of its parent, and
    /// not the first one. That tells which of the four triangles are siblings.
    bool lowest_is_second = false;
};

/// The forest above a step.
struct OrderedForest {
    std::vector<Triangle> roots;  ///< in the order of the step, with the vertices of the step
    std::vector<Leaf> leaves;     ///< in preorder, with the vertices of the step

    /// The mean distance of a midpoint from the middle of the edge that it bisects, relative to the length of
    /// the edge. It is about 0 under the right rule for vertices that stand still.
    double deviation = 0;
};

/// Coarsens \p step under \p rule.
/// \return none if there are more than \p max_roots roots
std::optional<OrderedForest> coarsen_by_order(const StepMesh& step, const OrderRule& rule,
                                              std::size_t max_roots);

}  // namespace interleaf
