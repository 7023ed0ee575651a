// The map between the plane of a parameter domain and the pixels that show it. Both axes have the same scale;
// v points up.
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

    /// The rectangle of the box, in pixels.
    Rect rect() const;

  private:
    DomainBox box_;
    glm::dvec2 corner_;  ///< pixel of (low x, high y)
    double scale_;       ///< pixels per unit
};

}  // namespace interleaf
