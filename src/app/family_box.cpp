#include "app/family_box.h"

#include <vector>

namespace interleaf {

Box bounding_box(const Family& family) {
    std::vector<glm::vec3> corners;
    for (const Key& key : family.keys) {
        const Box box = bounding_box(key.hierarchy.positions);
        corners.insert(corners.end(), {box.min, box.max});
    }
    return bounding_box(corners);
}

}  // namespace interleaf
