// Draws a parameter domain: its triangles, the path, the vertices with names and pictures of their keys, and
// the point of the blend.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "family/family.h"
#include "ui/widgets/plot_frame.h"
#include "ui/widgets/rect.h"

namespace interleaf {

struct DomainDrawing {
    const Family& family;  ///< with a domain
    const PlotFrame& frame;
    Rect area;                           ///< that the drawing fills; larger than the frame by a margin
    std::span<const unsigned> pictures;  ///< OpenGL texture per key; 0 for a picture that is not drawn yet
};

/// The triangles, colored by barycentric weight.
void draw_domain(const DomainDrawing& drawing);

/// Lines through the points of \p path.
void draw_path(const DomainDrawing& drawing, std::span<const glm::dvec2> path);

/// The vertices. Names that would overlap are left out; pictures have room where no other vertex is near.
/// \return the keys whose pictures have room
std::vector<std::size_t> draw_vertices(const DomainDrawing& drawing);

/// Rings around the vertices, which can be dragged.
/// \param near  under the pointer
void draw_vertex_rings(const DomainDrawing& drawing, std::optional<Index> near);

void draw_domain_point(glm::vec2 pixel, bool is_held);

}  // namespace interleaf
