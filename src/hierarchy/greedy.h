// Greedy refinement: bisects the leaf with the largest error, again and again, until a budget of leaves or a
// tolerance is reached.
#pragma once

#include <functional>
#include <limits>
#include <span>

#include "hierarchy/adaptive_mesh.h"

namespace interleaf {

struct GreedyOptions {
    /// Maximum number of leaves. Refinement comes as close to it as closure allows.
    Index leaves = std::numeric_limits<Index>::max();

    /// Leaves whose error is at most this are not bisected. Same unit as the error.
    double tolerance = 0;

    /// Called after each step, before the errors of the new leaves are requested, with the leaves that the
    /// step made: what AdaptiveMesh::refine() appends to its `changed`.
    std::function<void(const AdaptiveMesh&, std::span<const Index> changed)> after_step{};
};

/// The error of a leaf; never negative.
using LeafError = std::function<double(const AdaptiveMesh&, Index leaf)>;

/// Refines \p mesh by the errors that \p error returns for its leaves.
///
/// Each leaf's error is requested once: at the beginning, or when the leaf is made. It is not requested again
/// if it depends on other leaves and those change later.
///
/// Errors are compared in 12 significant bits, and the older of two equal leaves goes first. So rounding,
/// which differs between mathematical libraries, does not decide which of many equal leaves of a symmetric
/// surface comes first.
void refine_greedily(AdaptiveMesh& mesh, const LeafError& error, const GreedyOptions& options);

}  // namespace interleaf
