// Where leaves are: the root and the way down to each, from nothing but the levels of leaves in preorder.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "hierarchy/union_mesh.h"

namespace interleaf {

struct LeafPath {
    Index root = 0;
    std::uint64_t path = 0;  ///< bit n is the child taken at level n, as level_map() takes it
    bool operator==(const LeafPath&) const = default;
};

/// The paths of the leaves with the tags \p tags, root after root in preorder.
std::vector<LeafPath> leaf_paths(std::span<const LeafTag> tags);

}  // namespace interleaf
