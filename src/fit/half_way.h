// The area of the surface half way between two keys: a blend of parts that do not correspond shrinks.
#pragma once

#include <string>

#include <glm/mat3x3.hpp>

#include "hierarchy/hierarchy.h"

namespace interleaf {

/// The area of the surface half way between two keys that are both scaled to area 1, so that the smaller key counts as
/// much: 1 for a key and itself. It is measured over the union of the keys.
/// \param turn  applied to \p other
/// \throw InputError  if the roots differ
double half_way_area(const Hierarchy& key, const Hierarchy& other, const glm::dmat3& turn);

/// Why a matched key is not taken, in words; empty if it keeps about as much area half way as the unmatched key, or
/// more.
/// \param matched, unmatched  half_way_area() of these keys and the model's
std::string fault_of_half_way(double matched, double unmatched);

}  // namespace interleaf
