// How well a leaf fits the surface it stands for, by sampling its part of the surface on a regular grid.
#pragma once

#include <array>
#include <vector>

#include <glm/vec3.hpp>

#include "shapes/surfaces.h"

namespace interleaf {

struct LeafFit {
    double distance;  ///< largest distance of a sample from the leaf, in the surface's unit
    double apart;     ///< largest distance of a sample from its own point of the leaf, that of the same grid
                      ///< place: it bounds the distance both from surface to leaf and from leaf to surface
    double turn;      ///< largest difference between the leaf's unit normal and a grid triangle's: 0 to 2
    double size;      ///< longest edge
};

/// Points of the spherical triangle with these corners: its flat triangle's regular grid with \p parts parts
/// an edge, pushed out to the unit sphere. Row r, from corner 0 to the edge opposite, holds r + 1 points.
std::vector<glm::dvec3> sphere_grid(const std::array<glm::dvec3, 3>& corners, unsigned parts);

/// Distance of \p point from the closed triangle with these corners, which may be degenerate.
double distance_to_triangle(const glm::dvec3& point, const std::array<glm::dvec3, 3>& corners);

/// The fit to \p surface of the leaf over the spherical triangle with these corners: 12 samples beside them,
/// 16 grid triangles.
LeafFit measure_fit(Surface surface, const std::array<glm::dvec3, 3>& sphere_corners);

}  // namespace interleaf
