// Turns a spherical map so that directions on the sphere agree with directions in space.
//
// A spherical map is free up to a rotation. If the fronts of two bodies, seen from the middle of their
// surfaces, are mapped to different places of the sphere, a body turns inside out while it becomes the other.
// So each map is turned by the rotation under which sphere directions agree best with surface directions
// (Kabsch 1976; the form with a quaternion: Horn 1987). Keys that are aligned in this way are aligned to each
// other.
#pragma once

#include <span>

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include "fit/mesh/surface_mesh.h"

namespace interleaf {

/// The rotation R that maximizes the mean of (R u) . d, weighted by area. u is a vertex's point on the
/// sphere, and d is the direction of the vertex from the surface's center of area.
glm::dmat3 rotation_to_surface(const SurfaceMesh& mesh, std::span<const glm::dvec3> points);

/// The mean of u . d for the present map: 1 if all directions agree, -1 if all are opposite.
double mean_cosine(const SurfaceMesh& mesh, std::span<const glm::dvec3> points);

/// Rotates points of the unit sphere.
void rotate(std::span<glm::dvec3> points, const glm::dmat3& rotation);

}  // namespace interleaf
