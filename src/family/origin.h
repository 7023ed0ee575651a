// Where the numbers of a family's positions count from. Floats have seven digits: of a mesh in the
// coordinates of a map, millions of meters from 0, they would keep no detail. So such meshes are read in
// double, and a place of whole numbers is subtracted, one for all keys.
#pragma once

#include <span>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "family/family.h"
#include "hierarchy/triangle.h"

namespace interleaf {

/// The origin for a mesh: the middle of its box, in whole numbers, where the mesh is over 100 diagonals of
/// its box from 0; otherwise 0. \pre positions are finite
glm::dvec3 origin_for(std::span<const glm::dvec3> positions, std::span<const Triangle> triangles);

/// A sentence about an origin that is not 0: what was subtracted.
std::string origin_sentence(const glm::dvec3& origin);

/// Moves the positions of \p keys, which count from \p from, so that they count from \p to.
void move_origin(std::vector<Key>& keys, const glm::dvec3& from, const glm::dvec3& to);

}  // namespace interleaf
