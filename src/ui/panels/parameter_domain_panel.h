// The parameter domain (paper, figure 8): its triangles colored by barycentric weight, and the point to
// drag. Keys are dropped on it from their list; the right mouse button has what can be done to a vertex.
#pragma once

#include <optional>
#include <span>

#include <glm/vec2.hpp>

#include "family/family.h"
#include "ui/widgets/rect.h"

namespace interleaf {

struct DomainPanel {
    const std::optional<DomainPoint>& point;  ///< where the morph stands, if anywhere
    std::span<const glm::dvec2> path;         ///< the points the timeline passes, in their order
    bool edits = false;                       ///< dragging moves vertices, not the point
};

struct MovedVertex {
    Index vertex;
    glm::dvec2 to;
};

struct AddedVertex {
    glm::dvec2 at;
    std::size_t key;
};

struct VertexKey {
    Index vertex;
    std::size_t key;
};

struct ParameterDomainResult {
    std::optional<glm::dvec2> moved_to;  ///< where the pointer holds the point; may be outside the domain
    std::optional<MovedVertex> moved_vertex;  ///< held by the pointer
    std::optional<AddedVertex> added;         ///< wanted at a place
    std::optional<VertexKey> assigned;        ///< another key at a vertex
    std::optional<Index> removed;             ///< vertex
    double snap = 0;                          ///< what counts as touching, in units of the domain
    Rect plot;                                ///< the pixels of the bounding box of the domain's vertices
};

/// \pre  the family has a domain
ParameterDomainResult parameter_domain_panel(const Family& family, const DomainPanel& panel);

}  // namespace interleaf
