// A tube along a line: what marks an edge on a surface, with depth and light of its own.
#pragma once

#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "hierarchy/triangle.h"

namespace interleaf {

/// A closed surface, counter-clockwise seen from outside.
struct Tube {
    std::vector<glm::vec3> positions;
    std::vector<glm::vec3> normals;  ///< one a vertex, of length 1
    std::vector<Triangle> triangles;
};

/// The tube of radius \p radius about the line through \p points, round at its ends; about a single point, a
/// ball. \pre there is a point
Tube tube_along(std::span<const glm::vec3> points, float radius);

/// \p vector at length 1; \p otherwise where it has no direction.
glm::vec3 normalized_or(glm::vec3 vector, glm::vec3 otherwise);

/// A vector of length 1, at a right angle to \p axis. \pre \p axis is of length 1
glm::vec3 any_perpendicular(glm::vec3 axis);

}  // namespace interleaf
