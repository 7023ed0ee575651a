// What an indexed triangle mesh measures at each of its leaves or vertices.
#pragma once

#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "hierarchy/triangle.h"

namespace interleaf {

/// The smallest angle of each triangle in degrees, 0 to 60; 0 for a triangle of no area.
std::vector<float> smallest_angles(std::span<const Triangle> triangles, std::span<const glm::vec3> positions);

/// The mean curvature at each vertex: half the sum of the principal curvatures, above 0 where a surface whose
/// triangles are counter-clockwise from outside is convex, in the inverse unit of the positions.
///
/// It is half the divergence of the vertex normals, averaged over the triangles at the vertex, and so exact on a
/// sphere. (The cotangent Laplacian depends on how vertices are joined: on a bisected sphere its values go from 0
/// to 3 / R.) The boundary has the values of its neighbors.
std::vector<float> mean_curvatures(std::span<const Triangle> triangles, std::span<const glm::vec3> positions);

/// The distance of each point from its place in \p before.
/// \pre  both have the same length
std::vector<float> distances(std::span<const glm::vec3> before, std::span<const glm::vec3> after);

}  // namespace interleaf
