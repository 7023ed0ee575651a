#include "app/fitting/axis_turn.h"

#include <glm/gtc/matrix_transform.hpp>
#include <glm/trigonometric.hpp>

namespace interleaf {

glm::dmat3 matrix_of(const AxisTurn& turn) {
    glm::dvec3 axis(0);
    axis[turn.axis] = 1;
    return glm::dmat3(glm::rotate(glm::dmat4(1), glm::radians(turn.degrees), axis));
}

}  // namespace interleaf
