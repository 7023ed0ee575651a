// Makes landmarks vertices of a mesh: the nearest point of the mesh becomes a vertex where it is none. The
// surface stays the same set of points.
#pragma once

#include <span>
#include <vector>

#include "fit/mesh/surface_mesh.h"
#include "hierarchy/landmark.h"

namespace interleaf {

struct MeshWithLandmarks {
    SurfaceMesh mesh;               ///< the vertices of the given mesh, in order, then new ones
    std::vector<Index> vertices;    ///< of the landmarks, in their order, all different
    std::vector<double> distances;  ///< of the landmarks from the mesh, in the unit of the positions
};

/// Divides the triangle, or the two triangles at the edge, in which the point nearest to a landmark lies. A
/// point within a thousandth of a triangle from a corner or a side becomes that corner, or a point of that
/// side, so that no needles arise.
/// \param mesh  clean (clean_up.h)
/// \throw InputError naming two landmarks that become the same vertex
MeshWithLandmarks insert_landmarks(const SurfaceMesh& mesh, std::span<const Landmark> landmarks);

}  // namespace interleaf
