// The star of one vertex on the unit sphere, in coordinates of the tangent plane at the vertex. The star
// knows where the vertex may move, which is the star's kernel, and the best place for the vertex.
//
// Central projection takes a place (s, t) of the tangent plane at the center to a point of the sphere, so
// great circles are lines. All coordinates are differences from the center, so a star of size h is known to
// about 1e-16 / h of its size, however small it is.
#pragma once

#include <optional>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace interleaf {

/// The tangent plane at a point of the unit sphere.
struct TangentFrame {
    glm::dvec3 center;
    glm::dvec3 s_axis;
    glm::dvec3 t_axis;

    explicit TangentFrame(const glm::dvec3& unit_point);

    /// The point in the coordinates of the frame, minus the center.
    glm::dvec3 local(const glm::dvec3& point) const;
    /// The unit point that is the central projection of \p place, a place of the plane.
    glm::dvec3 point_at(const glm::dvec2& place) const;
};

/// What a map keeps in preference to the other. Shapes give better keys: where areas come first, leaves are
/// sheared, and ten times as many are flipped. But limbs that are many times longer than thick need room.
enum class Keeps { shapes, areas };

/// A spherical triangle (center, a, b) of a star, with its rest shape.
struct StarTriangle {
    glm::dvec3 a;           ///< in the frame, minus the center
    glm::dvec3 b;           ///< the next corner counter-clockwise
    glm::dvec3 normal;      ///< a x b: positive on the side of the great circle a b where the center may be
    double cotangent_to_a;  ///< of the rest angle opposite the edge to a
    double cotangent_to_b;
    double fixed_stretch;  ///< cotangent times squared length of the edge a b
    double area;           ///< target area, as a part of 4 pi
};

/// The distortion at one place of the vertex, summed over the triangles: area MIPS^p ((r + 1/r) / 2)^q. MIPS
/// is the conformal distortion (Hormann and Greiner 2000), 1 for a similar triangle. r is the ratio of the
/// spherical area to the target area (Degener et al. 2003). p and q are 2 and 1 where areas are kept, 3 and
/// 5/16 where shapes are kept.
///
/// Both distortions are computed from the determinant of the corners. The determinant is twice the area of a
/// small triangle, and 0 where the spherical triangle flips. So the energy is infinite at the edge of the
/// kernel, even for triangles that cover a good part of the sphere.
struct StarEnergy {
    double value = 0;
    glm::dvec2 gradient{0};
    double ss = 0;  ///< second derivatives
    double st = 0;
    double tt = 0;
};

struct NewtonStep {
    glm::dvec2 place{0};  ///< where the step ends; the center if no better place was found
    double gain = 0;      ///< relative decrease of the energy, 0 to 1
};

class SphericalStar {
  public:
    /// An empty star about \p center.
    explicit SphericalStar(const glm::dvec3& center, Keeps keeps = Keeps::areas)
        : frame_(center), keeps_(keeps) {}

    void restart(const glm::dvec3& center) {
        frame_ = TangentFrame(center);
        triangles_.clear();
    }

    const TangentFrame& frame() const { return frame_; }

    /// The square of the largest distance of a neighbor from the center.
    double squared_size() const;

    /// Adds the next triangle counter-clockwise.
    void add(const glm::dvec3& a, const glm::dvec3& b, double cotangent_to_a, double cotangent_to_b,
             double cotangent_across, double area);

    /// The energy at \p place. Infinite outside the kernel, or too close to its edge for double precision.
    double energy(const glm::dvec2& place) const;

    /// The energy at the center, with its derivatives.
    StarEnergy energy_at_center() const;

    bool has_center_in_kernel() const;

    /// The middle of the kernel (the mean of its corners), if doubles can tell the middle from the edge. Only
    /// the part of the kernel within about 84 degrees of the center counts.
    std::optional<glm::dvec2> middle_of_kernel() const;

    /// One step of Newton's method from the center. It never raises the energy and never leaves the kernel.
    NewtonStep newton_step() const;

  private:
    TangentFrame frame_;
    Keeps keeps_;
    std::vector<StarTriangle> triangles_;
};

}  // namespace interleaf
