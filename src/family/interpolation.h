// Interpolation bases: the weights of keys at given times (paper, sections 3.1 and 4.1). One table holds their
// names and functions (interpolation.cpp).
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "family/weights.h"

namespace interleaf {

struct TimelineKey {
    double time;      ///< in the unit of the timeline (TimeUnit)
    std::size_t key;  ///< index of the key in its family
    bool operator==(const TimelineKey&) const = default;
};

enum class Basis : std::uint8_t {
    linear,       ///< the keys before and after, in proportion to the distance in time (equation (2))
    hold,         ///< the key before, until the time of the next key
    bernstein,    ///< Bernstein polynomials (equation (4)); passes through the first and the last key only
    catmull_rom,  ///< cubic through all keys, continuously differentiable (spline_weights.h)
    b_spline,     ///< cubic near the keys, twice continuously differentiable (spline_weights.h)
    spline,       ///< cubic through all keys, twice continuously differentiable (spline_weights.h)
};

/// The number of bases: that of the last enumerator, plus one.
inline constexpr std::size_t basis_count = static_cast<std::size_t>(Basis::spline) + 1;

/// All bases, in the order of the enumeration, in which they are offered.
std::span<const Basis> bases();

/// "catmull-rom".
std::string_view name_of(Basis basis);

/// The basis called \p name; none when there is none.
std::optional<Basis> basis_named(std::string_view name);

/// How a timeline blends its keys.
struct Interpolation {
    Basis basis = Basis::linear;

    /// Of Basis::bernstein: the degree of its pieces. Each piece spans degree + 1 keys and begins at the last
    /// key of the previous piece; a last piece of fewer keys has a lower degree. 0 for one piece of all keys.
    std::size_t degree = 0;

    bool operator==(const Interpolation&) const = default;
};

/// The weights of \p keys at \p time; they sum to 1. The active keys change at the keys' times only.
///
/// Of Basis::spline, keys whose weights stay below 1e-7 between the two surrounding keys are left out, and
/// the remaining weights are divided by their sum.
/// \param keys  times strictly ascending
/// \param time  in the unit of the keys' times
/// \pre there is a key, and \p time is from the first key's time to the last one's
Weights weights_at(const Interpolation& interpolation, std::span<const TimelineKey> keys, double time);

}  // namespace interleaf
