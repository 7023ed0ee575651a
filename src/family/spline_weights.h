// Cubic spline bases over keys at times that need not be equidistant. Each function returns the weights of
// the keys at one time, by their places: Weight::key is an index into the times.
//
// The active places change at the times of keys only. At its own time, a key of an interpolating basis has
// the weight 1, and all other weights are exactly 0.
#pragma once

#include <cstddef>
#include <span>

#include "family/weights.h"

namespace interleaf {

/// The place i with times[i] <= \p time < times[i + 1]. The end belongs to the last interval.
/// \pre there are two times or more, strictly ascending, and \p time is between the first and the last
std::size_t interval_at(std::span<const double> times, double time);

/// Cubic Hermite interpolation with the tangents of Catmull and Rom (A class of local interpolating splines,
/// 1974) for any times, after Barry and Goldman (A recursive evaluation algorithm for a class of Catmull-Rom
/// splines, SIGGRAPH 1988): the tangent at a key is that of the parabola through the key and its neighbors;
/// at the first and the last key it is the slope to the neighbor. At most four places are active. Once
/// continuously differentiable.
/// \pre as interval_at()
Weights catmull_rom_weights(std::span<const double> times, double time);

/// The cubic B-spline whose control points are the keys (de Boor, A practical guide to splines, 1978). Its
/// ends are clamped: it begins at the first key and ends at the last one. The inner knots are the times of the
/// keys but the first two and the last two, so that there are as many basis functions as keys. Fewer than
/// four keys have a polynomial of degree keys - 1. At most four places are active. Twice continuously
/// differentiable; no weight is negative.
/// \pre as interval_at()
Weights b_spline_weights(std::span<const double> times, double time);

/// The natural cubic spline through the keys (de Boor 1978, chapter IV): its second derivative is continuous,
/// and 0 at both ends. All places are active.
/// \pre as interval_at()
Weights natural_spline_weights(std::span<const double> times, double time);

/// As natural_spline_weights(), without the places whose weights stay below \p threshold in the interval of
/// \p time. The remaining weights are divided by their sum.
Weights local_spline_weights(std::span<const double> times, double time, double threshold);

}  // namespace interleaf
