// Makes the points of a mapped surface that lie in given directions vertices.
#pragma once

#include <span>

#include <glm/vec3.hpp>

#include "fit/correspondence/sphere_mesh.h"

namespace interleaf {

/// Divides the triangle in which a direction lies. The new vertex stays clear of the triangle's border by a
/// thousandth of its height, so that the map remains one to one; a direction nearer to a corner takes that corner.
/// The vertices become landmarks. Of two directions at one vertex, the first counts.
/// \pre  the map of \p mesh is one to one
void insert_directions(SphereMesh& mesh, std::span<const glm::dvec3> directions);

}  // namespace interleaf
