// A grid through the origin whose step is a power of two. Its points are exact floats, and are stored as
// small integers.
#pragma once

#include <cmath>
#include <cstdint>
#include <optional>
#include <span>

#include <glm/vec3.hpp>

#include "hierarchy/buffer.h"

namespace interleaf {

class CoordinateGrid {
  public:
    /// The smallest and the largest exponent for which the step is a float.
    static constexpr int min_exponent = -149;
    static constexpr int max_exponent = 127;

    /// The grid with the step 2^\p exponent.
    explicit CoordinateGrid(int exponent)
        : exponent_(exponent), step_(std::ldexp(1.0, exponent)), inverse_step_(std::ldexp(1.0, -exponent)) {}

    int exponent() const { return exponent_; }

    /// The number of the grid point nearest to \p coordinate; 0 if that number is beyond 2^30, or if \p
    /// coordinate is NaN.
    std::int32_t number(double coordinate) const {
        const double steps = coordinate * inverse_step_;
        if (!(std::abs(steps) < 0x1p30)) return 0;
        return static_cast<std::int32_t>(steps < 0 ? steps - 0.5 : steps + 0.5);
    }

    float coordinate(std::int32_t number) const { return static_cast<float>(number * step_); }

  private:
    int exponent_;
    double step_;
    double inverse_step_;
};

/// The coarsest grid that contains all \p positions. There is none if a number on that grid is not below
/// 2^26, or if a coordinate is a negative zero, which a grid cannot distinguish from zero.
std::optional<CoordinateGrid> grid_of(std::span<const glm::vec3> positions);

/// \p positions, rounded to the coarsest grid with at least 2^\p bits steps along the longest side of their
/// bounding box. A coordinate moves by at most side / 2^(bits + 1).
Buffer<glm::vec3> rounded_positions(std::span<const glm::vec3> positions, unsigned bits);

}  // namespace interleaf
