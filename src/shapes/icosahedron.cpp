#include "shapes/icosahedron.h"

#include <cmath>

#include <glm/geometric.hpp>

namespace interleaf {

Hierarchy icosahedron() {
    const double phi = (1 + std::sqrt(5.0)) / 2;
    std::vector<glm::vec3> positions;
    for (const glm::dvec3& corner :
         {glm::dvec3(0, 1, phi), glm::dvec3(0, 1, -phi), glm::dvec3(0, -1, phi), glm::dvec3(0, -1, -phi),
          glm::dvec3(1, phi, 0), glm::dvec3(1, -phi, 0), glm::dvec3(-1, phi, 0), glm::dvec3(-1, -phi, 0),
          glm::dvec3(phi, 0, 1), glm::dvec3(-phi, 0, 1), glm::dvec3(phi, 0, -1), glm::dvec3(-phi, 0, -1)}) {
        positions.emplace_back(glm::normalize(corner));
    }
    const RootComplex roots(
        12, {{8, 0, 2},  {9, 2, 0},  {6, 0, 4},  {8, 4, 0},  {0, 6, 9},  {10, 3, 1}, {11, 1, 3},
             {4, 1, 6},  {1, 4, 10}, {11, 6, 1}, {5, 2, 7},  {2, 5, 8},  {9, 7, 2},  {7, 3, 5},
             {10, 5, 3}, {3, 7, 11}, {8, 10, 4}, {10, 8, 5}, {11, 9, 6}, {9, 11, 7}});
    return unrefined(roots, positions);
}

}  // namespace interleaf
