// The panel of the parameter domain (paper, figure 8): triangles colored by barycentric weight, and the point
// to drag. Keys are dropped on it from their list. The context menu offers the edits of vertices. While the
// domain is edited, the points of the path that drives are dragged, too.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include <glm/vec2.hpp>

#include "family/family.h"
#include "ui/panels/path_editing.h"
#include "ui/widgets/rect.h"

namespace interleaf {

/// The object that the left mouse button holds, from press to release.
struct DomainDrag {
    /// The box of the plot when the button was pressed. Moving a vertex must not move the plane under the
    /// pointer.
    DomainBox box;
    std::optional<Index> vertex;   ///< none for the point, and for a drag that began beside all vertices
    std::optional<PathPart> path;  ///< part of the path; none where a vertex is held
};

/// The subject of the context menu.
struct DomainMenu {
    std::optional<Index> vertex;   ///< none for a place without a vertex
    std::optional<PathPart> path;  ///< part of the path; it comes before a vertex
    glm::dvec2 at;
};

struct DomainPanel {
    const std::optional<DomainPoint>&
        point;                         ///< place of the blend in the domain; none if it has no place there
    std::span<const glm::dvec2> path;  ///< points that the timeline passes, in order
    bool is_recording = false;         ///< whether a path is being recorded
    bool edits = false;                ///< dragging moves vertices and points of the path, not the point
    bool has_focus = false;            ///< arrow keys move the point
    bool reads_keys = false;           ///< whether the panel may read the keyboard
    std::optional<std::size_t> selected = {};  ///< point of the path, while the domain is edited
    std::optional<DomainBox> view = {};        ///< the part that is shown; none for all
    std::span<const unsigned> pictures = {};   ///< OpenGL texture per key; 0 for one that is not drawn yet
    std::optional<DomainDrag> drag = {};       ///< from the last result
    std::optional<DomainMenu> menu = {};       ///< from the last result
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
    std::optional<glm::dvec2> moved_to;       ///< place of the dragged point; may be outside the domain
    std::optional<MovedVertex> moved_vertex;  ///< vertex that the user drags
    std::optional<AddedVertex> added;         ///< vertex that the user adds
    std::optional<VertexKey> assigned;        ///< key that the user gives to a vertex
    std::optional<Index> removed;             ///< vertex that the user removes
    std::optional<Index> asked_place;         ///< vertex whose place is to be typed
    PathEdit path;                            ///< edits of the path
    bool toggles_recording = false;           ///< the user begins or ends to record a path
    bool asks_for_place = false;              ///< the user wants to type the place of the point
    std::optional<bool> focus;                ///< the panel gets or loses the arrow keys
    std::optional<DomainBox> view;            ///< the part to show from now on
    std::vector<std::size_t> pictured;        ///< keys whose pictures have room
    std::optional<DomainDrag> drag;           ///< current drag: pass it to the next call
    std::optional<DomainMenu> menu;           ///< open menu: pass it to the next call
    double snap = 0;                          ///< distance at which two places touch, in units of the domain
    Rect plot;                                ///< bounding box of the domain's vertices, in pixels
};

/// \pre the family has a domain
ParameterDomainResult parameter_domain_panel(const Family& family, const DomainPanel& panel);

/// Takes the place of the panel while the family has no domain.
/// \return whether a new domain is wanted
bool domain_offer();

}  // namespace interleaf
