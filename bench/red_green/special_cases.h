// The special cases that an implementation of the red-green union must distinguish, counted. Under bisection
// all these counts are 0, except that a key can lie over a leaf in two ways: the leaf is a leaf of the key,
// or lies inside one.
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "overlay.h"

namespace interleaf::bench {

/// Leaves of one key with a green line, by the effect of the other keys on them. Each is two green triangles.
struct GreenPairs {
    std::size_t kept = 0;       ///< also in the overlay
    std::size_t split_red = 0;  ///< another key splits the leaf, and its red triangles lie across the line
    std::size_t crossed = 0;    ///< another key has another line there, green or of a larger leaf
    std::size_t count() const { return kept + split_red + crossed; }
};

struct SpecialCases {
    /// Leaves of the united red forest, by LeafKind.
    std::array<std::size_t, leaf_kind_count> leaves{};

    /// Number of occurring combinations of how the keys lie over a leaf, up to symmetries of the triangle and
    /// the order of the keys.
    std::size_t configurations = 0;

    /// Number of all combinations in which the leaf is a leaf of some key, up to the same symmetries.
    std::size_t possible_configurations = 0;

    /// Number of pairs of a midpoint and a key where the key's value is not the mean of its values at the
    /// ends of the edge, because the edge crosses a green line. Under bisection it always is the mean.
    std::size_t means_that_fail = 0;

    std::vector<GreenPairs> green_pairs;  ///< by key

    std::size_t conflicts() const {
        return leaves[std::size_t(LeafKind::across)] + leaves[std::size_t(LeafKind::crossing)] +
               leaves[std::size_t(LeafKind::triple)];
    }
};

SpecialCases special_cases(const Overlay& overlay, std::span<const RedGreenKey> keys);

}  // namespace interleaf::bench
