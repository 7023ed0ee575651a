// Polygons in the plane to divide, simple unless their names say otherwise, and what a division must hold.
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

/// The outlines of letters and the like, turning left, on whole numbers.
struct Outline {
    std::string name;
    Polygon polygon;
    double area;
};
std::vector<Outline> outlines();

/// The polygon that begins at the given corner, or goes around the other way.
Polygon begun_at(const Polygon& polygon, std::size_t corner);
Polygon turned_over(const Polygon& polygon);

/// A corner at each of \p count random angles.
Polygon star_shaped(std::size_t count, std::mt19937& random);

/// A way through \p count random points of a square that does not cross itself: where it does, the part
/// between is turned around (2-opt). On a grid of \p steps points a side, if that is not 0; points may lie on
/// other edges then.
Polygon uncrossed(std::size_t count, unsigned steps, std::mt19937& random);

/// The outline of squares of a grid that were added one beside the other, without holes; a corner at each
/// point of the grid that it comes by.
Polygon grown(std::size_t squares, std::mt19937& random);

/// Teeth, half of all corners at their tips.
Polygon comb(std::size_t count);

/// Two arms that wind around each other.
Polygon spiral(std::size_t count);

/// A band whose sides go up and down, rising by 45 degrees.
Polygon zigzag(std::size_t count);

/// Petals that all begin and end at one place.
Polygon flower(std::size_t petals);

/// A box with slits from above, whose ends lie on its lower side.
Polygon curtain(std::size_t slits);

/// A square with as many square holes, each with a seam to its left; of whole numbers.
Polygon keyholes(unsigned holes);

/// The way around up to \p squares squares of a grid of \p size by \p size, as one goes along the walls of a
/// maze that has one way to each square: edges between squares that are walls are gone along twice.
Polygon maze(int size, std::size_t squares, std::mt19937& random);

/// Twice the area, positive where the polygon turns left.
double doubled_area(const Polygon& polygon);

/// Whether a point is inside, by how often a ray from it meets the polygon.
bool is_inside(const Polygon& polygon, glm::dvec2 point);

/// Whether two edges cross at a point inside both, compared one by one. \pre whole numbers
bool do_edges_cross(const Polygon& polygon);

/// What is wrong about \p triangles as a division of the polygon; empty where nothing is: two triangles fewer
/// than corners, a disc whose boundary is the polygon, none turned over, areas that add up, and at
/// \p samples random points one triangle inside the polygon, none outside.
std::string division_fault(const Polygon& polygon, std::span<const Triangle> triangles, int samples,
                           std::mt19937& random);

/// The polygon in a plane of space.
std::vector<glm::dvec3> in_space(const Polygon& polygon);
std::vector<glm::dvec3> in_random_plane(const Polygon& polygon, std::mt19937& random);

}  // namespace interleaf
