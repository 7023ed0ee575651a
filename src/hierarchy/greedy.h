// Greedy refinement: always the leaf of the largest error next, until a budget of leaves or a tolerance is
// reached.
#pragma once

#include <functional>
#include <limits>
#include <span>

#include "hierarchy/adaptive_mesh.h"

namespace interleaf {

struct GreedyOptions {
    Index leaves =
        std::numeric_limits<Index>::max();  ///< at most this many leaves, and as near as closure allows
    double tolerance = 0;                   ///< leaves with no larger error stay; same unit as the error

    /// Told after each step, before errors are asked for, which leaves it made: what AdaptiveMesh::refine()
    /// appends to its `changed`.
    std::function<void(const AdaptiveMesh&, std::span<const Index> changed)> after_step{};
};

/// The error of a leaf, not negative.
using LeafError = std::function<double(const AdaptiveMesh&, Index leaf)>;

/// Refines \p mesh by the errors that \p error gives for its leaves, once for each: at the beginning, or when
/// the leaf is made. What the error of a leaf owes to others, and they change later, is not asked for again.
///
/// Errors are compared in 12 significant bits and the older of equal leaves goes first. So rounding, which
/// differs between mathematical libraries, does not decide which of many equal leaves of a symmetric surface
/// comes first.
void refine_greedily(AdaptiveMesh& mesh, const LeafError& error, const GreedyOptions& options);

}  // namespace interleaf
