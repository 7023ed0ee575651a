// Meshes as families that `interleaf render --color origin` draws with the special cases in color.
//
// Origin colors show which keys bisect a leaf. So each leaf of the red forest becomes one root triangle, or
// two if lines cross. There is one key per color, which bisects exactly the roots of that color, along their
// lines. All other leaves are gray. The keys are drawn with weight 1 each: one key holds the surface, the
// others hold only the displacements of their midpoints from the middle of the edge.
#pragma once

#include <array>
#include <span>
#include <string_view>
#include <vector>

#include "overlay.h"
#include <glm/vec3.hpp>

#include "family/family.h"

namespace interleaf::bench {

/// A leaf with all points where it may be divided.
struct PicturePiece {
    LeafKind kind = LeafKind::plain;
    std::array<glm::vec3, 3> corners{};
    std::array<bool, 3> lines{};         ///< whether each median is a line
    std::array<glm::vec3, 3> middles{};  ///< ends of the medians
    glm::vec3 centroid{};
};

/// The leaves of \p overlay with the keys blended by \p weights.
std::vector<PicturePiece> pieces_of(const Overlay& overlay, std::span<const double> weights);

/// Plain triangles, without special cases.
std::vector<PicturePiece> pieces_of(std::span<const Triangle> triangles,
                                    std::span<const glm::vec3> positions);

/// The family of \p pieces. Its keys are "across" (drawn orange), "surface", "green" (green) and "crossing"
/// (purple).
Family picture_family(std::span<const PicturePiece> pieces);

}  // namespace interleaf::bench
