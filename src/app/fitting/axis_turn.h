// A rotation about a coordinate axis, as options and dialogs specify it.
#pragma once

#include <glm/mat3x3.hpp>

namespace interleaf {

struct AxisTurn {
    int axis = 1;  ///< 0, 1, 2 for x, y, z
    double degrees = 0;
    bool operator==(const AxisTurn&) const = default;
};

/// The matrix that rotates column vectors counter-clockwise, seen from the positive end of the axis.
glm::dmat3 matrix_of(const AxisTurn& turn);

}  // namespace interleaf
