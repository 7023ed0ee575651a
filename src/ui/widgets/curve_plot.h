// A small plot of curves over time that share one scale.
#pragma once

#include <cstddef>
#include <functional>
#include <span>

#include <glm/vec2.hpp>

#include "ui/widgets/rect.h"

namespace interleaf {

class CurvePlot {
  public:
    /// The horizontal place of a time, in screen coordinates.
    using PlaceTime = std::function<float(double time)>;

    /// Draws the background of the plot in \p area.
    /// \param least, most  of the values; equal for curves that are constant
    CurvePlot(const Rect& area, PlaceTime place_time, double least, double most);

    /// \param times, values  of equal size
    void draw(std::span<const double> times, std::span<const double> values, unsigned color) const;

    /// Draws a line at \p time, if it is within the plot.
    void mark(double time) const;

    /// The place of the time among \p times that is nearest to \p pointer.
    /// \pre \p times is not empty
    std::size_t nearest(std::span<const double> times, glm::vec2 pointer) const;

  private:
    Rect area_;
    PlaceTime place_time_;
    double least_;
    double most_;
};

}  // namespace interleaf
