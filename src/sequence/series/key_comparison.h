// Figures that compare keys of a series with their steps and with each other, for the report.
#pragma once

#include <span>
#include <vector>

#include "hierarchy/hierarchy.h"
#include "sequence/series/step_mesh.h"

namespace interleaf {

/// The largest difference between the integrals of a scalar over \p key and over \p step, as a part of the area
/// of the step times the range of the scalar.
/// \param ranges  one per scalar; a scalar with range 0 does not count
double integral_error(const StepMesh& step, const Hierarchy& key, std::span<const double> ranges);

/// Per scalar of \p key, how far its fronts move from \p key to \p next, in widths of a front, times the range of the
/// scalar.
/// \pre  as moved_widths()
std::vector<double> moved_widths_times_range(const Hierarchy& key, const Hierarchy& next);

/// The most of these figures over all scalars, divided by the ranges.
/// \param ranges  one per scalar; a scalar with range 0 does not count
double widths_of(std::span<const double> widths_times_range, std::span<const double> ranges);

/// How far the fronts of a scalar move from \p key to \p next, in widths of a front; of the scalar with the
/// most.
///
/// A front is where a scalar changes from one end of its range to the other. With d the difference of the keys,
/// g the length of the gradient in \p key and R the range, fronts move by about int |d| / int g, and are about
/// R int g / int g^2 wide.
/// \param ranges  one per scalar; a scalar with range 0 does not count
/// \pre  both keys have equal roots and the same fields
double moved_widths(const Hierarchy& key, const Hierarchy& next, std::span<const double> ranges);

}  // namespace interleaf
