// Meshes as families that `interleaf render --color origin` draws with the special cases in colour.
//
// Origin colours tell which keys bisect a leaf. So each leaf of the red forest becomes a root triangle, or
// two where lines cross, and there is one key for each colour, which bisects the roots of that colour along
// their lines and no others. All other leaves are grey. The keys are drawn with weight 1 each: one holds the
// surface, the others only how far their midpoints lie from the middle of the edge.
#pragma once

#include <array>
#include <span>
#include <string_view>
#include <vector>

#include "overlay.h"
#include <glm/vec3.hpp>

#include "family/family.h"

namespace interleaf::bench {

/// A leaf with all points it may be divided at.
struct PicturePiece {
    LeafKind kind = LeafKind::plain;
    std::array<glm::vec3, 3> corners{};
    std::array<bool, 3> lines{};         ///< which medians are lines
    std::array<glm::vec3, 3> middles{};  ///< their ends
    glm::vec3 centroid{};
};

/// The leaves of \p overlay where the keys are blended by \p weights.
std::vector<PicturePiece> pieces_of(const Overlay& overlay, std::span<const double> weights);

/// Triangles without anything special.
std::vector<PicturePiece> pieces_of(std::span<const Triangle> triangles,
                                    std::span<const glm::vec3> positions);

/// The family of \p pieces. Its keys are "across" (drawn orange), "surface", "green" (green) and "crossing"
/// (purple).
Family picture_family(std::span<const PicturePiece> pieces);

}  // namespace interleaf::bench
