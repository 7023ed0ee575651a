// Paths of leaves: the root of each leaf and the path down to it, computed from nothing but the levels of the
// leaves in preorder.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "hierarchy/union_mesh.h"

namespace interleaf {

struct LeafPath {
    Index root = 0;
    std::uint64_t path = 0;  ///< bit n is the child taken at level n, as in level_map()
    bool operator==(const LeafPath&) const = default;
};

/// The paths of the leaves with the tags \p tags, root after root in preorder.
std::vector<LeafPath> leaf_paths(std::span<const LeafTag> tags);

}  // namespace interleaf
