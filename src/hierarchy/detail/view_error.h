// How much a deviation matters in a picture: more where it is seen large and at silhouettes, less outside the
// picture and where the surface faces away.
//
// All functions are continuous, so that what depends on them changes continuously with the camera. None of them
// needs to be monotone over a hierarchy: view_refinement.h makes it so.
#pragma once

#include <glm/vec3.hpp>

namespace interleaf {

/// The view of a camera.
struct ViewPoint {
    glm::vec3 eye{0};
    glm::vec3 forward{0, 0, -1};  ///< unit vector
    float cosine = 0.9F;          ///< of the angle between forward and the corners of the picture
};

struct Ball {
    glm::vec3 center{0};
    float radius = 0;
};

/// A ball as the eye sees it.
class SeenBall {
  public:
    SeenBall(const ViewPoint& view, const Ball& ball);

    /// What a length inside the ball is multiplied with to compare it in the picture: 1 / distance from the
    /// nearest point of the ball, where the ball is in the picture; down to 1/64 of it outside.
    float magnification() const { return magnification_; }

    /// From 1/4, for a surface that the camera faces, to 1 where a silhouette is possible: where a normal in
    /// a cone is perpendicular to the direction from some point of the ball to the eye.
    /// \param axis       unit vector; of the cone, as in DetailBisection
    /// \param sine       as in DetailBisection
    /// \param is_closed  whether nobody sees the surface from behind; there the result goes down to 1/16
    float prominence(const glm::vec3& axis, float sine, bool is_closed) const;

  private:
    bool is_inside_;       ///< whether the eye is in the ball
    glm::vec3 to_eye_{0};  ///< unit vector
    float sine_ = 0;       ///< of the angle under which the eye sees the radius
    float magnification_ = 0;
};

}  // namespace interleaf
