// Cuts a hierarchy to a level of detail: keeps the vertices whose error (vertex_errors.h) is above a
// threshold. Every threshold gives a conforming hierarchy over the same roots, a key like any other.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "hierarchy/hierarchy.h"

namespace interleaf {

/// The threshold that keeps every vertex, also those whose error is 0.
inline constexpr float keep_everything = -1;

/// The hierarchy of the vertices of \p hierarchy whose error is above \p threshold, with their positions and
/// fields. Its Hausdorff distance from \p hierarchy is at most \p threshold.
/// \param errors     what vertex_errors() returns for \p hierarchy
/// \param threshold  in the unit of positions; infinity leaves the roots alone
/// \pre  \p hierarchy passes check(), as then does the result
Hierarchy cut(const Hierarchy& hierarchy, std::span<const float> errors, float threshold);

/// The size of every cut of a hierarchy.
class CutSizes {
  public:
    /// \param errors  what vertex_errors() returns for \p hierarchy
    CutSizes(const Hierarchy& hierarchy, std::span<const float> errors);

    /// Number of leaves of the cut at \p threshold.
    std::size_t leaf_count(float threshold) const;

    /// The smallest threshold whose cut has at most \p max_leaves leaves; keep_everything if the whole
    /// hierarchy has no more.
    /// \pre  \p max_leaves is at least the number of roots
    float threshold(std::size_t max_leaves) const;

    /// The largest error that the cut at \p threshold leaves out, at most \p threshold: a bound of its
    /// Hausdorff distance from the hierarchy. 0 if it leaves none out.
    float distance(float threshold) const;

  private:
    struct Step {
        float error;
        std::size_t leaves;  ///< leaves of the cut that keeps this error and larger ones
    };
    std::size_t root_count_;
    std::vector<Step> steps_;  ///< one per error of a midpoint, descending
};

}  // namespace interleaf
