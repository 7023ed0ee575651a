// How well a leaf fits the surface it stands for, by sampling its part of the surface on a regular grid.
#pragma once

#include <array>
#include <vector>

#include <glm/vec3.hpp>

#include "shapes/base_surface.h"
#include "shapes/surfaces.h"

namespace interleaf {

struct LeafFit {
    double distance;  ///< largest distance of a sample from the leaf, in the surface's unit
    double apart;     ///< largest distance of a sample from its own point of the leaf, that of the same grid
                      ///< place: it bounds the distance both from surface to leaf and from leaf to surface
    double turn;      ///< largest difference between the leaf's unit normal and a grid triangle's: 0 to 2
    double size;      ///< longest edge
};

/// Points of the part of \p base over the triangle with these corners: the triangle's regular grid with \p
/// parts parts an edge, projected. Row r, from corner 0 to the edge opposite, holds r + 1 points.
std::vector<glm::dvec3> base_grid(const BaseSurface& base, const std::array<glm::dvec3, 3>& corners,
                                  unsigned parts);

/// Distance of \p point from the closed triangle with these corners, which may be degenerate.
double distance_to_triangle(const glm::dvec3& point, const std::array<glm::dvec3, 3>& corners);

/// The fit to \p surface, a map of \p base, of the leaf over these points of the base: 12 samples beside
/// them, 16 grid triangles.
LeafFit measure_fit(const BaseSurface& base, Surface surface, const std::array<glm::dvec3, 3>& base_corners);

}  // namespace interleaf
