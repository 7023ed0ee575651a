// The deformation flow of LeVeque ("High-Resolution Conservative Algorithms for Advection in Incompressible
// Flow", 1996), with the ball of Enright, Fedkiw, Ferziger, Mitchell ("A Hybrid Particle Level Set Method for
// Improved Interface Capturing", 2002) in it. The flow keeps volumes, stretches the ball into a thin curved
// sheet, and turns back at half of its period: at the period every point is where it was.
#pragma once

#include <cstddef>
#include <unordered_map>

#include <glm/vec3.hpp>

namespace interleaf {

/// The ball at time 0, in the unit cube.
inline constexpr glm::dvec3 flow_ball_center{0.35, 0.35, 0.35};
inline constexpr double flow_ball_radius = 0.15;

/// The velocity of the flow.
/// \param at      a point of the unit cube
/// \param time    seconds
/// \param period  seconds after which every point is where it was
glm::dvec3 deformation_velocity(const glm::dvec3& at, double time, double period);

/// Where the flow has moved the point of the ball's sphere in \p direction, a unit vector.
///
/// The velocity is a steady field times a number that changes in time, so the point moves along a line of the
/// steady field, as far as the number's integral says.
/// \param time      seconds
/// \param strength  factor of the velocity
/// \param period    of the flow, seconds
glm::dvec3 flowed_point(const glm::dvec3& direction, double time, double strength, double period);

/// The sphere of the ball, whose points the flow moves. A point has a name: its direction from the center at
/// time 0. Its present position depends on nothing but its name and the number of steps.
class FlowingSphere {
  public:
    /// The sphere at time 0.
    /// \param period  of the flow, seconds
    /// \param steps   number of steps per period
    FlowingSphere(double period, unsigned steps);

    /// The present position of the point \p direction, a unit vector. If the point was not requested since
    /// the last step, it is traced from time 0.
    glm::dvec3 at(const glm::dvec3& direction);

    /// Moves all points by one step of time, with the Runge-Kutta method of order 4 in parts of a step.
    void advance();

  private:
    struct DirectionHash {
        std::size_t operator()(const glm::dvec3& direction) const;
    };
    struct TracedPoint {
        glm::dvec3 position;
        bool is_requested;  ///< since the last step
    };

    glm::dvec3 traced(glm::dvec3 position, unsigned first_step, unsigned end_step) const;

    double period_;
    double step_length_;      ///< seconds
    unsigned parts_of_step_;  ///< Runge-Kutta steps per step
    unsigned step_ = 0;
    std::unordered_map<glm::dvec3, TracedPoint, DirectionHash> points_;
};

}  // namespace interleaf
