// The parameter domain (paper, figure 8): its triangles colored by barycentric weight, and the point to
// drag. Keys are dropped on it from their list; the right mouse button has what can be done to a vertex.
#pragma once

#include <optional>
#include <span>

#include <glm/vec2.hpp>

#include "family/family.h"
#include "ui/widgets/rect.h"

namespace interleaf {

/// What the left mouse button holds, from press to release.
struct DomainDrag {
    /// The box of the plot when the button was pressed, because moving a vertex must not move the plane under the pointer.
    DomainBox box;
    std::optional<Index> vertex;  ///< none for the point, and beside all vertices
};

/// What the menu of the right mouse button is about.
struct DomainMenu {
    std::optional<Index> vertex;  ///< none for a place without a vertex
    glm::dvec2 at;
};

struct DomainPanel {
    const std::optional<DomainPoint>& point;  ///< where the morph stands, if anywhere
    std::span<const glm::dvec2> path;         ///< the points the timeline passes, in their order
    bool edits = false;                       ///< dragging moves vertices, not the point
    std::optional<DomainDrag> drag = {};      ///< the last result's
    std::optional<DomainMenu> menu = {};      ///< the last result's
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
    std::optional<glm::dvec2> moved_to;  ///< where the pointer drags the point; may be outside the domain
    std::optional<MovedVertex> moved_vertex;  ///< dragged by the pointer
    std::optional<AddedVertex> added;         ///< asked for at a place
    std::optional<VertexKey> assigned;        ///< another key at a vertex
    std::optional<Index> removed;             ///< vertex
    std::optional<DomainDrag> drag;           ///< goes on: hand it to the next call
    std::optional<DomainMenu> menu;           ///< stays: hand it to the next call
    double snap = 0;                          ///< distance that counts as touching, in units of the domain
    Rect plot;                                ///< the pixels of the bounding box of the domain's vertices
};

/// \pre  the family has a domain
ParameterDomainResult parameter_domain_panel(const Family& family, const DomainPanel& panel);

}  // namespace interleaf
