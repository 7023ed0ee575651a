// Surfaces that every ray from the origin meets once, with the map to the sphere that follows from this.
#pragma once

#include <functional>
#include <vector>

#include "fit/mesh/surface_mesh.h"

namespace interleaf::testing {

struct MappedMesh {
    SurfaceMesh mesh;
    std::vector<glm::dvec3> points;  ///< of the unit sphere, one per vertex
};

/// The surface at the distance \p radius(direction) from the origin; 20 4^n triangles.
MappedMesh star_shape(unsigned divisions, const std::function<double(const glm::dvec3&)>& radius);

MappedMesh unit_sphere_mesh(unsigned divisions);

/// An ellipsoid with bumps.
MappedMesh bumpy_ellipsoid(unsigned divisions);

/// A ball with a thin spike made by a single vertex of the mesh: its tip is at (0, 0, 3).
MappedMesh ball_with_spike(unsigned divisions);

/// A ball with six long arms.
MappedMesh six_arms(unsigned divisions);

}  // namespace interleaf::testing
