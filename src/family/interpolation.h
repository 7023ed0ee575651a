// Interpolation bases: the weights of keys at given times (paper, sections 3.1 and 4.1). One table holds
// their names and functions.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "family/weights.h"

namespace interleaf {

struct TimelineKey {
    double time;      ///< seconds
    std::size_t key;  ///< index of the key in its family
    bool operator==(const TimelineKey&) const = default;
};

/// How a timeline blends its keys.
enum class Interpolation : std::uint8_t {
    linear,  ///< the keys before and after, in proportion to the distance in time (equation (2))
};

/// All bases, in the order in which they are offered.
std::span<const Interpolation> interpolations();

/// "linear".
std::string_view name_of(Interpolation interpolation);

/// The basis called \p name; none when there is none.
std::optional<Interpolation> interpolation_named(std::string_view name);

/// The weights of \p keys at \p time. The active keys change at the keys' times only.
/// \param keys  times strictly ascending
/// \param time  seconds
/// \pre there is a key, and \p time is from the first key's time to the last one's
Weights weights_at(Interpolation interpolation, std::span<const TimelineKey> keys, double time);

}  // namespace interleaf
