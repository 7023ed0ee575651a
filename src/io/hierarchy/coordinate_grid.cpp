#include "io/hierarchy/coordinate_grid.h"

#include <algorithm>
#include <bit>
#include <limits>

#include "hierarchy/measure.h"

namespace interleaf {

namespace {

/// The exponent of the lowest set bit of \p coordinate; none for zero.
std::optional<int> min_exponent(float coordinate) {
    constexpr unsigned fraction_bits = 23;
    const auto image = std::bit_cast<std::uint32_t>(coordinate);
    const std::uint32_t fraction = image & ((1U << fraction_bits) - 1);
    const int exponent = static_cast<int>(image >> fraction_bits & 0xff);
    if (exponent == 0 && fraction == 0) return std::nullopt;
    const std::uint32_t significand = exponent == 0 ? fraction : fraction | 1U << fraction_bits;
    return CoordinateGrid::min_exponent + std::max(exponent, 1) - 1 + std::countr_zero(significand);
}

double longest_side(std::span<const glm::vec3> positions) {
    const Box box = bounding_box(positions);
    const glm::dvec3 sides = glm::dvec3(box.max) - glm::dvec3(box.min);
    return std::max({sides.x, sides.y, sides.z});
}

float rounded(float coordinate, double step) {
    // Adding +0 turns -0 into +0; a grid has no -0.
    const double nearest = std::nearbyint(coordinate / step) * step + 0.0;
    // The grid extends beyond the range of floats.
    const double most = std::floor(double{std::numeric_limits<float>::max()} / step) * step;
    return static_cast<float>(std::clamp(nearest, -most, most));
}

}  // namespace

std::optional<CoordinateGrid> grid_of(std::span<const glm::vec3> positions) {
    constexpr int number_bits = 26;
    int lowest = CoordinateGrid::max_exponent;
    int highest = CoordinateGrid::min_exponent;
    for (const glm::vec3& position : positions)
        for (int axis = 0; axis < 3; ++axis) {
            const float coordinate = position[axis];
            if (const std::optional<int> exponent = min_exponent(coordinate)) {
                lowest = std::min(lowest, *exponent);
                highest = std::max(highest, std::ilogb(coordinate));
            } else if (std::signbit(coordinate)) {
                return std::nullopt;
            }
            if (highest - lowest >= number_bits) return std::nullopt;
        }
    return CoordinateGrid(lowest);
}

Buffer<glm::vec3> rounded_positions(std::span<const glm::vec3> positions, unsigned bits) {
    Buffer<glm::vec3> result(positions.begin(), positions.end());
    const double side = longest_side(positions);
    if (!(side > 0)) return result;
    const int exponent = std::max(std::ilogb(side) - static_cast<int>(bits), CoordinateGrid::min_exponent);
    const double step = std::ldexp(1.0, exponent);
    for (glm::vec3& position : result)
        for (int axis = 0; axis < 3; ++axis) position[axis] = rounded(position[axis], step);
    return result;
}

}  // namespace interleaf
