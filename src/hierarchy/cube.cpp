#include "hierarchy/cube.h"

#include <utility>
#include <vector>

#include <glm/vec3.hpp>

namespace interleaf {

Hierarchy cube() {
    std::vector<glm::vec3> corners;
    corners.reserve(8);
    for (unsigned v = 0; v < 8; ++v)
        corners.emplace_back((v & 1) != 0 ? 1 : -1, (v & 2) != 0 ? 1 : -1, (v & 4) != 0 ? 1 : -1);
    // The diagonals are the edges of a tetrahedron: three meet at each of four corners.
    std::vector<Triangle> triangles = {{1, 0, 3}, {2, 3, 0}, {4, 5, 6}, {7, 6, 5}, {1, 5, 0}, {4, 0, 5},
                                       {2, 6, 3}, {7, 3, 6}, {2, 0, 6}, {4, 6, 0}, {1, 3, 5}, {7, 5, 3}};
    return unrefined(RootComplex(8, std::move(triangles)), corners);
}

}  // namespace interleaf
