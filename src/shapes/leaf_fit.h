// How well a leaf fits its part of the surface, measured by sampling that part on a regular grid.
#pragma once

#include <array>
#include <vector>

#include <glm/vec3.hpp>

#include "shapes/base_surface.h"
#include "shapes/surfaces.h"

namespace interleaf {

struct LeafFit {
    double distance;  ///< largest distance of a sample from the leaf, in the surface's unit
    /// Largest distance of a sample from the point of the leaf at the same grid place; it bounds the distance
    /// from surface to leaf and from leaf to surface.
    double apart;
    double turn;  ///< largest difference between the leaf's unit normal and that of a grid triangle: 0 to 2
    double size;  ///< longest edge
};

/// Points of \p base over the triangle with these corners: the triangle's regular grid, projected.
/// \param parts  number of grid intervals per edge
/// \return row after row; row r, counted from corner 0 towards the opposite edge, holds r + 1 points
std::vector<glm::dvec3> base_grid(const BaseSurface& base, const std::array<glm::dvec3, 3>& corners,
                                  unsigned parts);

/// Distance of \p point from the closed triangle with these corners, which may be degenerate.
double distance_to_triangle(const glm::dvec3& point, const std::array<glm::dvec3, 3>& corners);

/// The fit of a leaf to \p surface, a map of \p base. The leaf lies over the given points of the base. Uses
/// 12 samples besides these points, and 16 grid triangles.
LeafFit measure_fit(const BaseSurface& base, const Surface& surface,
                    const std::array<glm::dvec3, 3>& base_corners);

}  // namespace interleaf
