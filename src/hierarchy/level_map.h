// Level maps (paper, section 2.1, equation (1)): where a triangle lies within an ancestor, in barycentric
// coordinates.
//
// With bisection (i, j, k) -> (l, k, i), (l, i, j) a point with coordinates b = (b1, b2, b3) in a child has
// in the parent
//     first child  (l, k, i):  (b3, b1/2, b1/2 + b2)
//     second child (l, i, j):  (b2, b1/2 + b3, b1/2).
// The paper's equation (1) prints the two the other way round; this is the one its own vertex order (figure
// 4) gives.
#pragma once

#include <cstdint>

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

namespace interleaf {

/// Barycentric coordinates in the parent of the point \p b of its first (\p child 0) or second (1) child.
glm::dvec3 level_map(unsigned child, const glm::dvec3& b);

/// The composition of the level maps along a path: from coordinates in the triangle that \p path leads to, \p
/// level bisections deep, to coordinates in the triangle it starts from. Bit n of \p path is the child taken
/// at level n. Column c is the image of corner c.
glm::dmat3 level_map(std::uint64_t path, unsigned level);

}  // namespace interleaf
