// Vectors and triangles in space: lengths, normals, places on a triangle, and the distance of a point from it.
#pragma once

#include <array>
#include <cstddef>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace interleaf {

inline double squared_length(const glm::dvec3& vector) {
    return glm::dot(vector, vector);
}

/// The corners of a triangle in space.
using TriangleCorners = std::array<glm::dvec3, 3>;

/// The unit normal; zero for a triangle without area.
glm::dvec3 unit_normal(const TriangleCorners& corners);

/// Twice the area.
double doubled_area(const TriangleCorners& corners);

/// A triangle as two chains from one end of its longest side to the other: the side itself, and the two other
/// sides. Long thin triangles are cut into strips between them.
class LongTriangle {
  public:
    explicit LongTriangle(const TriangleCorners& corners);

    double length() const { return length_; }  ///< of the longest side

    /// Places of the two chains at the fraction \p part, 0 to 1, of the way along the longest side.
    glm::dvec3 on_side(double part) const { return begin_ + part * (end_ - begin_); }
    glm::dvec3 on_other_sides(double part) const;

    double apex_part() const { return apex_part_; }  ///< the fraction at which the other sides meet
    const glm::dvec3& apex() const { return apex_; }

  private:
    glm::dvec3 begin_;
    glm::dvec3 end_;
    glm::dvec3 apex_;
    double length_ = 0;
    double apex_part_ = 0;
};

/// Barycentric coordinates of places on a triangle: the points of the grid that divides each edge into
/// \p parts, without the corners.
template <int parts>
constexpr auto barycentric_grid() {
    std::array<glm::dvec3, (parts + 1) * (parts + 2) / 2 - 3> places{};
    std::size_t count = 0;
    for (int i = 0; i < parts; ++i)
        for (int j = i == 0 ? 1 : 0; j < parts && i + j <= parts; ++j)
            places[count++] = {double(i) / parts, double(j) / parts, double(parts - i - j) / parts};
    return places;
}

/// The square of the distance of \p point from the closed triangle with these corners. The triangle may be
/// degenerate (Ericson, Real-Time Collision Detection, 2005, section 5.1.5: the regions of its plane).
double squared_distance_to_triangle(const glm::dvec3& point, const TriangleCorners& corners);

/// The barycentric coordinates of the place on that triangle that is nearest to \p point: not negative, sum 1
/// up to rounding.
glm::dvec3 nearest_place(const glm::dvec3& point, const TriangleCorners& corners);

}  // namespace interleaf
