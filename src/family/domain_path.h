// A path through a parameter domain: points at times, and a straight motion of constant speed from each point
// to the next. A point that is dragged through the domain gives such a path; simplified() and smoothed() make
// it fit to edit. A path knows no domain: family_time.h has the weights along it.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include <glm/vec2.hpp>

namespace interleaf {

struct PathPoint {
    double time;    ///< seconds
    glm::dvec2 at;  ///< in domain units
    bool operator==(const PathPoint&) const = default;
};

class DomainPath {
  public:
    /// Upper limit of the number of points: 18 minutes of 60 points per second.
    static constexpr std::size_t max_points = 65'536;

    /// \throw InputError unless there are 1 to max_points points, times and coordinates are finite, and times
    ///     are strictly ascending
    explicit DomainPath(std::vector<PathPoint> points);

    std::span<const PathPoint> points() const { return points_; }
    double begin() const { return points_.front().time; }
    double end() const { return points_.back().time; }

    /// The point at \p time, clamped to begin() and end().
    /// \throw InputError if \p time is not a number
    glm::dvec2 at(double time) const;

    /// Edits. Each returns the changed path.
    /// @{

    /// With \p added, too.
    /// \throw InputError as the constructor
    DomainPath with_point(const PathPoint& added) const;

    /// With the point \p place at another time and place. It may pass other points.
    /// \throw InputError as the constructor
    DomainPath with_point_moved(std::size_t place, const PathPoint& to) const;

    /// Without the point \p place; none if it is the only one.
    std::optional<DomainPath> without_point(std::size_t place) const;

    /// @}

    bool operator==(const DomainPath&) const = default;

  private:
    std::vector<PathPoint> points_;
};

/// The path with some of its points, the first and the last included, that stays within \p tolerance of
/// \p path at every time. Takes the points by the method of Douglas and Peucker (1973). The measure is the
/// distance of the two paths' points at the same time, so speeds and rests stay, too.
/// \param tolerance  in domain units, not negative; 0 leaves out only points that change nothing
/// \throw InputError if \p tolerance is negative or not a number
DomainPath simplified(const DomainPath& path, double tolerance);

/// The path smoothed over time. It has points at the same times, and its first and last point stay.
///
/// The filter is a Gaussian in time. It applies to the deviation from a straight motion of constant speed
/// between the two ends, which continues beyond each end by reflection in time and sign. So the ends stay,
/// and such a straight motion does not change. However many points there are within a standard deviation, the
/// time is in proportion to the number of points.
/// \param seconds  standard deviation of the Gaussian; 0 changes nothing
/// \throw InputError if \p seconds is negative or not a number, or if coordinates overflow
DomainPath smoothed(const DomainPath& path, double seconds);

}  // namespace interleaf
