#include "app/document/family_extent.h"

#include <algorithm>
#include <vector>

#include <glm/geometric.hpp>

namespace interleaf {

Extent extent(const Family& family) {
    std::vector<glm::vec3> corners;
    for (const Key& key : family.keys) {
        const Box box = bounding_box(key.hierarchy->positions);
        corners.insert(corners.end(), {box.min, box.max});
    }
    Extent result{bounding_box(corners), 0};
    for (const Key& key : family.keys)
        for (const glm::vec3& position : key.hierarchy->positions)
            result.radius = std::max(result.radius, glm::distance(position, result.box.center()));
    return result;
}

}  // namespace interleaf
