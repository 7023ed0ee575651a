// Mean curvature flow of a triangle mesh, the gradient flow of its area, with the cotangent Laplacian in
// implicit steps (Desbrun, Meyer, Schroeder, Barr, "Implicit Fairing of Irregular Meshes using Diffusion and
// Curvature Flow", 1999). A vertex stands for its Voronoi area, with which the curvature of a sphere is exact,
// and at least for half of its mixed area (Meyer, Desbrun, Schroeder, Barr, "Discrete Differential-Geometry
// Operators for Triangulated 2-Manifolds", 2003). Thirds of the triangles would let the vertices of bisected
// meshes, which have four or eight triangles, flow at different speeds.
//
// All arrays by vertex may have places that no triangle uses.
#pragma once

#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "hierarchy/triangle.h"

namespace interleaf {

/// Whether each vertex stays where it is.
using Pinned = std::vector<bool>;

/// Moves the vertices by one implicit step of the flow, whose speed is the sum of the principal curvatures.
/// \param length     the time that passes
/// \param positions  by vertex
void step_to_smaller_area(std::span<const Triangle> triangles, const Pinned& is_pinned, double length,
                          std::span<glm::dvec3> positions);

/// Per vertex, half the sum of the principal curvatures; positive where the surface bends away from its
/// normal, as a sphere does. The formula needs the whole neighborhood of a vertex. So a pinned vertex gets the
/// mean of the neighbors that are not pinned, or 0 if there are none.
std::vector<float> mean_curvatures(std::span<const Triangle> triangles, const Pinned& is_pinned,
                                   std::span<const glm::dvec3> positions);

/// Per vertex, the unit normal: the mean of the normals of its triangles, weighted by their areas. 0 where
/// that is 0.
std::vector<glm::dvec3> area_weighted_normals(std::span<const Triangle> triangles,
                                              std::span<const glm::dvec3> positions);

}  // namespace interleaf
