// The origin of a family's positions. Floats have seven digits, so they keep no detail of a mesh in map
// coordinates, millions of meters from 0. Readers therefore read such meshes in double precision and subtract
// a point with whole-number coordinates, the same for all keys.
#pragma once

#include <span>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "family/family.h"
#include "hierarchy/triangle.h"

namespace interleaf {

/// The origin for a mesh: the center of its box, in whole numbers, if the mesh is farther from 0 than 100
/// diagonals of its box; otherwise 0.
/// \pre  positions are finite
glm::dvec3 origin_for(std::span<const glm::dvec3> positions, std::span<const Triangle> triangles);

/// A sentence that tells which point was subtracted.
/// \pre  \p origin is not 0
std::string origin_sentence(const glm::dvec3& origin);

/// Converts the positions of \p keys from the origin \p from to the origin \p to.
void move_origin(std::vector<Key>& keys, const glm::dvec3& from, const glm::dvec3& to);

}  // namespace interleaf
