// The mesh of a refinement that suits one view (view_refinement.h): a union of cuts whose newest vertices still
// grow out of the middles of their edges, and its blend.
#pragma once

#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "hierarchy/buffer.h"
#include "hierarchy/detail/view_refinement.h"
#include "hierarchy/field.h"
#include "hierarchy/hierarchy.h"
#include "hierarchy/union_mesh.h"

namespace interleaf {

struct ViewMesh {
    /// The union of the cuts. Its vertices have grown as far as `growth` says. Without own_vertices: see `own`.
    UnionMesh mesh{};

    /// own[v * key count + i]: the vertex of key i that vertex v is; no_index if key i has none there.
    std::vector<Index> own{};

    std::vector<float> growth{};    ///< per vertex, 0 at the middle of its edge to 1 at its own place
    Buffer<glm::vec3> positions{};  ///< of the blend

    /// Of the blend, not normalized. The normal of a vertex grows out of the mean of its edge's ends, too.
    Buffer<glm::vec3> normals{};
};

/// Writes the mesh of \p view to \p result, and reuses its memory.
/// \param keys     those of the refinement
/// \param weights  those of the refinement
void view_mesh(const RefinedView& view, std::span<const Hierarchy* const> keys,
               std::span<const float> weights, ViewMesh& result);

/// The blend of the field \p label, one stream, which grows with the vertices; colors are linear light.
/// \param keys     those of the refinement; each has the field
/// \param weights  those of the refinement
UnionField view_field(const ViewMesh& view, std::span<const Hierarchy* const> keys,
                      std::span<const float> weights, const FieldName& label);

}  // namespace interleaf
