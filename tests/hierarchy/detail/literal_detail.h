// Slow, literal versions of levels of detail.
#pragma once

#include <vector>

#include <glm/vec3.hpp>

#include "hierarchy/hierarchy.h"

namespace interleaf::testing {

/// The deviation of each bisected node, from the barycentric coordinates that each vertex below has in the
/// node's triangle.
std::vector<double> literal_deviations(const Hierarchy& hierarchy);

/// The errors of the vertices by refinement from the roots: bisects the triangle with the largest deviation,
/// and then every triangle with a hanging vertex, until everything is bisected.
/// \param deviations  one per bisected node
std::vector<float> literal_errors(const Hierarchy& hierarchy, const std::vector<float>& deviations);

/// The distance of \p point from the closed triangle with the corners \p a, \p b and \p c.
double literal_distance(const glm::dvec3& point, const glm::dvec3& a, const glm::dvec3& b,
                        const glm::dvec3& c);

}  // namespace interleaf::testing
