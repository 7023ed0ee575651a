// Fits a key to each step of a series of closed surfaces that move and are meshed anew, such as those of Surface
// Evolver or of bubbles in a fluid, where no bisection connects the meshes of two steps.
//
// The maps of all steps to the sphere belong together: each one continues that of the step before, or where that gives
// no good key is matched to it (fit/correspondence). So a part of the surface stays the same part while it moves.
#pragma once

#include <string>

#include "sequence/series/series.h"

namespace interleaf {

/// Whether fit_steps() knows what to do with \p options: no roots and no displacement are given.
bool can_be_fitted(const SeriesOptions& options);

/// Fits the keys.
/// \param options   the tolerance, if set, is the largest distance of a key from its step, as a part of the diagonal
///                  of the box (FitOptions); by default, a key has at most 20,000 leaves
/// \param reason    why recover() has refused the series; for notes and errors
/// \param progress  as SeriesProgress
/// \pre  can_be_fitted()
/// \throw InputError  "step N: ...", if a step is no closed surface without handles, or has no good key, or lacks a
///                    field; with \p reason
/// \throw UsageError  if the tolerance is out of its range
SeriesReport fit_steps(const Series& series, const SeriesOptions& options, const std::string& reason,
                       const TakeKey& take_key, const SeriesProgress& progress);

}  // namespace interleaf
