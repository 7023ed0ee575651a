#include "app/document/family_extent.h"

#include <span>
#include <vector>

namespace interleaf {

Extent extent(const Family& family) {
    std::vector<std::span<const glm::vec3>> parts;
    parts.reserve(family.keys.size());
    for (const Key& key : family.keys) parts.emplace_back(key.hierarchy->positions);
    return extent_of(parts);
}

}  // namespace interleaf
