// A tube along a line, which marks an edge on a surface; it takes part in depth test and lighting.
#pragma once

#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "hierarchy/triangle.h"

namespace interleaf {

/// A closed surface, counter-clockwise seen from outside.
struct Tube {
    std::vector<glm::vec3> positions;
    std::vector<glm::vec3> normals;  ///< one per vertex, of length 1
    std::vector<Triangle> triangles;
};

/// The tube of radius \p radius along the line through \p points, with round ends; a ball for a single point.
/// \pre there is at least one point
Tube tube_along(std::span<const glm::vec3> points, float radius);

/// \p vector scaled to length 1; \p otherwise if it has no direction.
glm::vec3 normalized_or(glm::vec3 vector, glm::vec3 otherwise);

/// A vector of length 1 perpendicular to \p axis.
/// \pre \p axis has length 1
glm::vec3 any_perpendicular(glm::vec3 axis);

}  // namespace interleaf
