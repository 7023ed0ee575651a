// Brings several bodies to one size, one place and one up direction before keys are made of them. Without
// this, most of a morph would be growth and movement.
#pragma once

#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "fit/clean_up/clean_up.h"
#include "fit/mesh/surface_mesh.h"
#include "hierarchy/up_axis.h"

namespace interleaf {

/// Undoes turn_up(), to the last bit.
void turn_back(std::vector<glm::dvec3>& positions, UpAxis up);

/// Turns \p positions so that \p up becomes y. The result is exact, because the turn only swaps coordinates
/// and signs.
void turn_up(std::vector<glm::dvec3>& positions, UpAxis up);

struct PlacingOptions {
    bool same_size = false;    ///< whether the square root of the area becomes that of the first mesh
    bool same_center = false;  ///< whether the centroid of the area becomes that of the first mesh
};

/// The size and the place of a surface.
struct SurfaceExtent {
    double size = 0;       ///< square root of the area
    glm::dvec3 center{0};  ///< centroid of the area
    glm::dvec3 least{0};   ///< corners of the box
    glm::dvec3 most{0};
};

/// \pre there is at least one triangle
SurfaceExtent extent_of(const SurfaceMesh& mesh);

/// Scales \p mesh about its center and moves it, as \p options demand.
/// \param first  extent of the first mesh
void place(CleanMesh& mesh, const SurfaceExtent& first, const PlacingOptions& options);

/// Why a morph from one body to the other may be hard to follow: the sizes differ by a factor of more than 3,
/// or the boxes do not touch. Empty if neither is the case.
std::string fault_of_placing(const SurfaceExtent& first, const SurfaceExtent& other);

}  // namespace interleaf
