// A plain indexed triangle mesh as it comes from a file.
#pragma once

#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "hierarchy/field_mesh.h"
#include "hierarchy/hierarchy.h"
#include "hierarchy/triangle.h"

namespace interleaf {

struct SurfaceMesh {
    std::vector<glm::dvec3> positions;
    std::vector<Triangle> triangles;  ///< counter-clockwise seen from outside, once the mesh is clean
    std::vector<glm::vec3> colors;    ///< one per vertex, linear or as in the file, 0 to 1; empty if none

    /// Fields of one component that a key takes over, with one value per vertex. Their names differ, and can be
    /// names of a key's fields.
    std::vector<MeshField> scalars{};
};

/// The diagonal of the axis-aligned box around a mesh with vertices.
double box_diagonal(const SurfaceMesh& mesh);

/// Appends to each of \p scalars the weighted mean of its values at \p vertices, the value of a new vertex.
void append_mean(std::vector<MeshField>& scalars, std::span<const Index> vertices,
                 std::span<const double> weights);

/// The leaves of a key, without colors and scalars.
/// \pre \p key has passed check()
SurfaceMesh surface_of(const Hierarchy& key);

}  // namespace interleaf
