// Polygons in the plane, simple unless their names say otherwise, and the conditions that a division of them
// must meet.
#pragma once

#include <random>
#include <span>
#include <string>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "hierarchy/triangle.h"

namespace interleaf {

using Polygon = std::vector<glm::dvec2>;

/// Outlines of letters and similar shapes, counterclockwise, with integer corners.
struct Outline {
    std::string name;
    Polygon polygon;
    double area;
};
std::vector<Outline> outlines();

/// The same polygon, beginning at the given corner, or in reverse order.
Polygon begun_at(const Polygon& polygon, std::size_t corner);
Polygon turned_over(const Polygon& polygon);

/// A polygon with a corner at each of \p count random angles.
Polygon star_shaped(std::size_t count, std::mt19937& random);

/// A polygon through \p count random points of a square that does not cross itself. Where it does, the part
/// between the crossing edges is reversed (2-opt).
/// \param steps  if not 0, points lie on a grid of this many points per side, and may lie on other edges
Polygon uncrossed(std::size_t count, unsigned steps, std::mt19937& random);

/// The outline of squares of a grid that were added one beside the other, without holes. It has a corner at
/// every grid point on the way.
Polygon grown(std::size_t squares, std::mt19937& random);

/// Teeth. Half of all corners are at their tips.
Polygon comb(std::size_t count);

/// Two arms that wind around each other.
Polygon spiral(std::size_t count);

/// A zigzag band that rises by 45 degrees.
Polygon zigzag(std::size_t count);

/// Petals that all begin and end at one point.
Polygon flower(std::size_t petals);

/// A box with slits from its upper side. The ends of the slits lie on the lower side.
Polygon curtain(std::size_t slits);

/// A square with \p holes square holes, each with a seam to its left. Corners are integers.
Polygon keyholes(unsigned holes);

/// The path along the walls of a maze that connects up to \p squares squares of a grid of \p size by \p size,
/// with exactly one way to each square. The path runs twice along each wall between two of the squares.
Polygon maze(int size, std::size_t squares, std::mt19937& random);

/// Twice the area, positive if the polygon turns left.
double doubled_area(const Polygon& polygon);

/// Whether a point is inside, which the number of edges on a ray from the point decides.
bool is_inside(const Polygon& polygon, glm::dvec2 point);

/// Whether two edges cross at a point inside both. Compares all pairs of edges.
/// \pre corners are integers
bool do_edges_cross(const Polygon& polygon);

/// The fault of \p triangles as a division of the polygon; empty if there is none. A division has two
/// triangles fewer than corners and is a disc whose boundary is the polygon. No triangle is flipped, and the
/// areas add up. At \p samples random points, one triangle covers a point inside the polygon, and no triangle
/// covers a point outside.
std::string division_fault(const Polygon& polygon, std::span<const Triangle> triangles, int samples,
                           std::mt19937& random);

/// The polygon in the plane z = 0, or in a random plane.
std::vector<glm::dvec3> in_space(const Polygon& polygon);
std::vector<glm::dvec3> in_random_plane(const Polygon& polygon, std::mt19937& random);

}  // namespace interleaf
