// Editing the path through the parameter domain: its points are dragged, inserted by dragging the line between
// them, and have a menu.
#pragma once

#include <cstddef>
#include <optional>

#include <glm/vec2.hpp>

#include "family/domain_path.h"
#include "ui/widgets/plot_frame.h"

namespace interleaf {

/// The part of a path under the pointer: one of its points, or the line behind one.
struct PathPart {
    std::size_t place;  ///< of the point; of the first one of the line
    bool is_line;
    bool operator==(const PathPart&) const = default;

    /// Whether \p path has this part. A part can be older than the path.
    bool is_of(const DomainPath& path) const { return place + (is_line ? 1 : 0) < path.points().size(); }
};

struct MovedPathPoint {
    std::size_t place;
    glm::dvec2 to;
};

struct PathEdit {
    std::optional<std::size_t> selected;     ///< point that the user selects
    std::optional<MovedPathPoint> moved;     ///< point that the user moves
    std::optional<PathPoint> inserted;       ///< point that the user inserts
    std::optional<std::size_t> removed;      ///< point that the user removes
    std::optional<std::size_t> asked_time;   ///< point whose time is to be typed
    std::optional<std::size_t> asked_place;  ///< point whose place is to be typed
};

/// The part of \p path nearest to \p pointer, a point rather than a line; none if all are too far away.
std::optional<PathPart> path_part_near(const DomainPath& path, const PlotFrame& frame, glm::vec2 pointer);

/// The point on the line of \p path behind \p place that is nearest to \p at, and its time.
PathPoint point_on_line(const DomainPath& path, std::size_t place, glm::dvec2 at);

/// The entries of the context menu for \p part. \p at is the place of the menu.
void show_path_menu(const DomainPath& path, const PathPart& part, glm::dvec2 at, PathEdit& edit);

/// Draws the points of \p path; points that would overlap are left out.
/// \param near      under the pointer
void draw_path_points(const DomainPath& path, const PlotFrame& frame,
                      const std::optional<std::size_t>& selected, const std::optional<PathPart>& near,
                      glm::vec2 pointer);

}  // namespace interleaf
