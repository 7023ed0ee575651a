// The map between the plane of a parameter domain and the pixels it is drawn on: one scale for both axes, v
// up.
#pragma once

#include <glm/vec2.hpp>

#include "family/parameter_domain.h"
#include "ui/widgets/rect.h"

namespace interleaf {

class PlotFrame {
  public:
    /// Fits \p box into \p area, centered.
    PlotFrame(const DomainBox& box, const Rect& area);

    glm::vec2 pixel(glm::dvec2 point) const;
    glm::dvec2 point(glm::vec2 pixel) const;

    /// The pixels of the box.
    Rect rect() const;

  private:
    DomainBox box_;
    glm::dvec2 corner_;  ///< pixel of (low x, high y)
    double scale_;       ///< pixels per unit
};

}  // namespace interleaf
