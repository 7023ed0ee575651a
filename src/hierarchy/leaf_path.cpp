#include "hierarchy/leaf_path.h"

#include <bit>

namespace interleaf {

namespace {

/// A mask of the lowest \p count bits, 0 to 64.
constexpr std::uint64_t first_bits(unsigned count) {
    return count == 0 ? 0 : ~std::uint64_t{0} >> (64 - count);
}

/// The leaf that follows \p leaf, which has the level \p level. Consider the deepest bisection at which
/// \p leaf lies in the first child: the next leaf lies in the second child, and in first children from there
/// on. If there is no such bisection, the root is complete.
LeafPath next(const LeafPath& leaf, unsigned level) {
    const std::uint64_t first_children = ~leaf.path & first_bits(level);
    if (first_children == 0) return {leaf.root + 1, 0};
    const auto deepest = static_cast<unsigned>(std::bit_width(first_children)) - 1;
    return {leaf.root, (leaf.path & first_bits(deepest)) | std::uint64_t{1} << deepest};
}

}  // namespace

std::vector<LeafPath> leaf_paths(std::span<const LeafTag> tags) {
    std::vector<LeafPath> paths;
    paths.reserve(tags.size());
    LeafPath leaf;
    for (const LeafTag tag : tags) {
        paths.push_back(leaf);
        leaf = next(leaf, tag.level());
    }
    return paths;
}

}  // namespace interleaf
