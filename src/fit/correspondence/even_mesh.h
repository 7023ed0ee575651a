// Gives a mapped surface a mesh of about equal edges: halves long edges, then collapses short ones.
//
// New vertices lie on the old triangles, in space and on the sphere, so the map stays the same map. Collapses
// change the surface by less than a fraction of an edge, and keep all triangles positive on the sphere.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "fit/correspondence/sphere_mesh.h"
#include "fit/mesh/half_edge_mesh.h"
#include "fit/mesh/progress_meter.h"
#include "fit/mesh/surface_mesh.h"
#include "hierarchy/progress.h"
#include "hierarchy/triangle.h"

namespace interleaf {

/// The edge of a mesh of equilateral triangles with \p vertices vertices and area 1.
double even_edge(double vertices);

/// The triangles that are there now.
std::vector<Triangle> triangles_in(const HalfEdgeMesh& mesh);

/// Halves the longest edges until none is longer than an even mesh of \p vertices vertices allows, or until eight
/// times as many vertices are added.
/// \return the ends of the halved edges; their middles follow the vertices of \p mesh, in this order
/// \pre the triangles of \p mesh are a closed surface of area 1
/// \throw Cancelled
std::vector<std::array<Index, 2>> split_long_edges(SphereMesh& mesh, std::size_t vertices,
                                                   ProgressMeter& meter);

/// \p mesh with the middles of the halved edges, without colors and scalars.
/// \param halved     as split_long_edges() returns them for a body of this mesh
/// \param triangles  of that body
SurfaceMesh with_middles(const SurfaceMesh& mesh, std::span<const std::array<Index, 2>> halved,
                         const std::vector<Triangle>& triangles);

/// A mapped surface on fewer of its vertices, and the way back to all of them.
struct CoarsenedMesh {
    SphereMesh mesh;               ///< with numbers of its own
    std::vector<Index> vertices;   ///< the number that each of its vertices has in the whole mesh
    HalfEdgeMesh half_edges;       ///< the whole mesh, collapsed
    std::vector<Index> collapses;  ///< the collapsed half-edges, in order
};

/// Collapses short edges of \p mesh until it has \p vertices vertices, among them all landmarks, or no more can be
/// collapsed.
/// \param mesh  area 1; its map is one to one
/// \throw Cancelled
CoarsenedMesh coarsened(const SphereMesh& mesh, std::size_t vertices, const Progress& progress);

}  // namespace interleaf
