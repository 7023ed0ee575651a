// Level maps (paper, section 2.1, equation (1)): the position of a triangle within an ancestor, in
// barycentric coordinates.
//
// With the bisection (i, j, k) -> (l, k, i), (l, i, j), a point with coordinates b = (b1, b2, b3) in a child
// has these coordinates in the parent:
//     first child  (l, k, i):  (b3, b1/2, b1/2 + b2)
//     second child (l, i, j):  (b2, b1/2 + b3, b1/2).
// The paper's equation (1) prints the two maps the other way round. The maps here follow from the paper's own
// vertex order (figure 4).
#pragma once

#include <cstdint>

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

namespace interleaf {

/// Barycentric coordinates in the parent of the point \p b in its first (\p child 0) or second (1) child.
glm::dvec3 level_map(unsigned child, const glm::dvec3& b);

/// The composition of the level maps along a path. It maps coordinates in the triangle at the end of \p path,
/// \p level bisections deep, to coordinates in the triangle where the path starts.
/// \param path  bit n is the child taken at level n
/// \return column c is the image of corner c
glm::dmat3 level_map(std::uint64_t path, unsigned level);

}  // namespace interleaf
