// A polygon in the plane that fits it best, on an integer grid, so that orientations are decided exactly.
#pragma once

#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

namespace interleaf {

/// The number of steps of the grid along the longer side of a polygon's box. A product of two differences
/// fits 64 bits.
inline constexpr std::int64_t plane_steps = std::int64_t{1} << 29;

/// A point of the grid, from 0 to plane_steps on both axes.
struct PlanePoint {
    std::int64_t x = 0;
    std::int64_t y = 0;

    bool operator==(const PlanePoint&) const = default;
    auto operator<=>(const PlanePoint&) const = default;
};

/// Twice the signed area of a triangle: positive if \p a, \p b, \p c turn left.
constexpr std::int64_t orientation(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

inline double distance(const PlanePoint& a, const PlanePoint& b) {
    return std::hypot(static_cast<double>(b.x - a.x), static_cast<double>(b.y - a.y));
}

struct PlanePolygon {
    std::vector<PlanePoint> points;  ///< one per corner; equal corners have equal points

    /// The largest distance of a corner from the plane through the middle of the corners, as a fraction of
    /// the longer side of their box in the plane.
    double bulge = 0;
};

/// The corners of a polygon in the plane across its area vector (Newell's method). The polygon turns left
/// around that vector. There are no points if all corners lie nearly on one line, because then no plane fits
/// best.
/// \pre at least three corners, all finite
PlanePolygon in_plane(std::span<const glm::dvec3> corners);

}  // namespace interleaf
