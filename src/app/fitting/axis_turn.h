// A turn about an axis of the coordinate system, as options and dialogs have it.
#pragma once

#include <glm/mat3x3.hpp>

namespace interleaf {

struct AxisTurn {
    int axis = 1;  ///< 0, 1, 2 for x, y, z
    double degrees = 0;
    bool operator==(const AxisTurn&) const = default;
};

/// Of directions as columns, counter-clockwise seen from the axis's end.
glm::dmat3 matrix_of(const AxisTurn& turn);

}  // namespace interleaf
