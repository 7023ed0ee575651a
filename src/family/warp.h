// Warps flat keys by a field: the value of the field becomes a height over the plane, as in a map with mountains.
#pragma once

#include <optional>
#include <string>

#include "hierarchy/hierarchy.h"
#include "hierarchy/measure.h"

namespace interleaf {

/// The axis, 0 to 2, along which \p box is thin, relative to its size; none if it is not flat.
std::optional<unsigned> flat_axis(const Box& box);

struct Warp {
    unsigned axis = 2;    ///< along which positions move, 0 to 2
    std::string field{};  ///< a scalar
    float factor = 1;     ///< positions move by factor (value - zero)
    float zero = 0;
    bool operator==(const Warp&) const = default;
};

/// \p key with its positions moved; as it is, if it lacks the scalar.
Hierarchy warped(const Hierarchy& key, const Warp& warp);

}  // namespace interleaf
