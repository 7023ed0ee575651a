// Recovery by sampling: bisects given roots until linear interpolation differs from a flat step by at most a
// tolerance, whatever the triangles of the step are.
#pragma once

#include <functional>
#include <span>

#include "hierarchy/hierarchy.h"
#include "sequence/series/coarsest_mesh.h"
#include "sequence/series/step_mesh.h"

namespace interleaf {

struct PlaneSampling {
    unsigned axis = 2;  ///< across the plane of the roots and of the step

    /// The largest difference of a scalar, as a part of its range. With 0, a node is bisected until a cell of
    /// the step holds it.
    double tolerance = 0.01;
    std::span<const double> ranges{};  ///< one per scalar; 0 for a scalar that is the same everywhere
    std::function<void()> report{};    ///< called now and then; it may throw to end the work
};

struct SampledKey {
    Hierarchy key;
    double largest_difference = 0;  ///< of the worst scalar, as a part of its range
};

/// The key of \p step over \p roots. Its values at a vertex are those of the step there, or, outside of the
/// step, at the nearest place among the triangles nearby. A node is bisected if it exceeds the tolerance, which
/// is measured exactly, or if the closure needs it.
/// \throw InputError  if the roots and the step are not at one place, or more leaves would be needed than a key
///     can reasonably have
SampledKey sample_in_plane(const StepMesh& step, const SeriesRoots& roots, const SeriesFields& fields,
                           const PlaneSampling& sampling);

}  // namespace interleaf
