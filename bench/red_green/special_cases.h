// What an implementation of the red-green union has to tell apart, counted. Under bisection all these counts
// are 0, or for the ways a key lies over a leaf two: it is a leaf of the key, or lies inside one.
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "overlay.h"

namespace interleaf::bench {

/// Leaves of one key that have a green line, by what the other keys do to them. Each is two green triangles.
struct GreenPairs {
    std::size_t kept = 0;       ///< also in the overlay
    std::size_t split_red = 0;  ///< another key splits the leaf, its red triangles lie across the line
    std::size_t crossed = 0;    ///< another key has another line there, green or of a larger leaf
    std::size_t count() const { return kept + split_red + crossed; }
};

struct SpecialCases {
    /// Leaves of the united red forest, by LeafKind.
    std::array<std::size_t, leaf_kind_count> leaves{};

    /// Combinations of how the keys lie over a leaf that occur, up to symmetries of the triangle and the
    /// order of the keys.
    std::size_t configurations = 0;

    /// The same, for all combinations in which the leaf is one of some key's.
    std::size_t possible_configurations = 0;

    /// Midpoints and keys where the key's value is not the mean of its values at the ends of the edge, as it
    /// always is under bisection, since the edge crosses a green line.
    std::size_t means_that_fail = 0;

    std::vector<GreenPairs> green_pairs;  ///< of each key

    std::size_t conflicts() const {
        return leaves[std::size_t(LeafKind::across)] + leaves[std::size_t(LeafKind::crossing)] +
               leaves[std::size_t(LeafKind::triple)];
    }
};

SpecialCases special_cases(const Overlay& overlay, std::span<const RedGreenKey> keys);

}  // namespace interleaf::bench
