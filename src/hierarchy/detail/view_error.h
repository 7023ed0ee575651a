// How much a deviation matters in a picture: more where it is seen large and at silhouettes, less outside the
// picture and where the surface faces away.
//
// All functions are continuous, so that what depends on them changes continuously with the camera. None of them
// needs to be monotone over a hierarchy: view_refinement.h makes it so.
#pragma once

#include <glm/vec3.hpp>

#include "hierarchy/detail/normal_cones.h"

namespace interleaf {

/// The view of a camera.
struct ViewPoint {
    glm::vec3 eye{0};
    glm::vec3 forward{0, 0, -1};  ///< unit vector
    float half_angle = 0.5F;      ///< between forward and the corners of the picture, radians
};

struct Ball {
    glm::vec3 center{0};
    float radius = 0;
};

/// What a length inside \p ball is multiplied with to compare it in the picture: 1 / distance from the nearest
/// point of the ball, where the ball is in the picture; down to 1/64 of it outside.
float magnification(const ViewPoint& view, const Ball& ball);

/// From 1/4, for a surface that the camera faces, to 1 where a silhouette is possible: where a normal in
/// \p cone is perpendicular to the direction from some point of \p ball to the eye.
/// \param is_closed  whether nobody sees the surface from behind; there the result goes down to 1/16
float prominence(const ViewPoint& view, const Ball& ball, const NormalCone& cone, bool is_closed);

}  // namespace interleaf
