// The figures of a key: its size, its depth and the shape of its triangles.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "hierarchy/hierarchy.h"
#include "hierarchy/measure.h"

namespace interleaf {

struct Figures {
    std::size_t roots;
    std::size_t leaves;
    std::size_t vertices;
    unsigned min_level;  ///< over all leaves
    unsigned max_level;
    std::size_t memory;    ///< bytes
    std::uintmax_t file;   ///< bytes
    double min_angle;      ///< degrees
    int euler;             ///< Euler number
    std::size_t boundary;  ///< boundary edges of the root complex; 0 if it is closed
    Box box;
    std::string_view form{};  ///< of the file: "plain" or "compressed"; empty for a mesh or several keys
};

/// \param file  size of the key's file, bytes
Figures figures_of(const Hierarchy& key, std::uintmax_t file);

/// The figures of several keys over the same roots: sums of counts and sizes, extremes of levels and angles,
/// and the box of all keys.
/// \pre \p keys is not empty
Figures total(std::span<const Figures> keys);

}  // namespace interleaf
