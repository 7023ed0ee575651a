// The outline of a triangle over a picture, with the numbers of its corners.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include <glm/vec2.hpp>

#include "ui/widgets/rect.h"

namespace interleaf {

/// A part of a side that is seen, or hidden, as a whole.
struct OutlineLine {
    std::vector<glm::vec2> points;
    bool is_refinement_edge = false;
    bool is_hidden = false;
};

struct Outline {
    std::vector<OutlineLine> lines{};
    std::array<std::optional<glm::vec2>, 3> corners{};  ///< none behind the camera
};

/// \p outline, which is in pixels of a picture, in window coordinates.
/// \param corner   of the picture in the window, upper left
/// \param density  pixels per window coordinate
Outline in_window(Outline outline, glm::vec2 corner, float density);

/// Draws \p outline behind all panels. Hidden parts are faint; the refinement edge has a color of its own.
/// \param outline  window coordinates
/// \param area     clips the drawing
/// \param has_numbers  whether the corners have their numbers, 1 to 3
void outline_mark(const Outline& outline, const Rect& area, bool has_numbers);

}  // namespace interleaf
