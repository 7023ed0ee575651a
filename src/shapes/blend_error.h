// How far a blend of a shape's keys is from the shape with constants between those of the keys.
#pragma once

#include <span>

#include <glm/vec3.hpp>

#include "hierarchy/union_mesh.h"
#include "shapes/shapes.h"

namespace interleaf {

/// The largest distance of a point of the blend from the point of the shape that it stands for, in the shape's
/// unit; taken at the vertices and the centers of the leaves. It bounds the distance between both surfaces there.
/// \param mesh       the union of keys of the shape, with any constants
/// \param positions  the blend, one per vertex of \p mesh
/// \pre \p shape has a surface
double distance_from(const Shape& shape, const UnionMesh& mesh, std::span<const glm::vec3> positions);

}  // namespace interleaf
