// Coarsens a closed mesh by half-edge collapses, shortest edges first, to even triangles.
//
// A collapse is made only if the mesh stays a simplicial complex, all triangles stay positive on a sphere, no
// triangle turns far against its old normal, and shapes stay good or become no worse. So each coarser mesh is
// a map of the surface to the sphere, too, and the collapses can be undone in reverse order.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "fit/mesh/half_edge_mesh.h"
#include "fit/mesh/progress_meter.h"

namespace interleaf {

struct CoarseningView {
    std::span<const glm::dvec3> positions;  ///< of a surface of area 1, one per vertex
    std::span<const glm::dvec3> points;     ///< on the sphere; every triangle is positive

    /// Where the mesh lies on another surface; the triangles there keep good shapes, too. May be empty.
    std::span<const glm::dvec3> images{};

    /// Vertices that are removed first, if they can be: 1 per such vertex, else 0. May be empty.
    std::span<const char> are_first{};

    /// Vertices that are never removed: 1 per such vertex, else 0. May be empty.
    std::span<const char> are_held{};

    /// Other numbers but 0 give other coarse meshes: lengths count up to a quarter more or less.
    std::uint32_t variation = 0;
};

/// Collapses edges until \p mesh has \p vertices vertices, or no more can be collapsed.
/// \return the collapsed half-edges, in order (HalfEdgeMesh::undo_collapse())
/// \throw Cancelled
std::vector<Index> coarsen(HalfEdgeMesh& mesh, std::size_t vertices, const CoarseningView& view,
                           ProgressMeter& meter);

}  // namespace interleaf
