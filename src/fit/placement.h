// Brings several bodies to one size and one place, and the right way up, before keys are made of them: else
// most of a morph is their growing and moving.
#pragma once

#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "fit/clean_up/clean_up.h"
#include "fit/mesh/surface_mesh.h"

namespace interleaf {

/// The axis of a mesh that points up.
enum class UpAxis { x, y, z };

/// Turns \p positions so that \p up becomes y; exactly, for that only swaps coordinates and signs.
void turn_up(std::vector<glm::dvec3>& positions, UpAxis up);

struct PlacingOptions {
    bool same_size = false;    ///< the square root of the area is the first mesh's
    bool same_center = false;  ///< the centroid of the area is the first mesh's
};

/// The size and the place of a surface.
struct SurfaceExtent {
    double size = 0;       ///< square root of the area
    glm::dvec3 center{0};  ///< centroid of the area
    glm::dvec3 least{0};   ///< corners of the box
    glm::dvec3 most{0};
};

/// \pre there is a triangle
SurfaceExtent extent_of(const SurfaceMesh& mesh);

/// Scales \p mesh about its center, and moves it, as \p options say.
/// \param first  of the first mesh
void place(CleanMesh& mesh, const SurfaceExtent& first, const PlacingOptions& options);

/// Why a morph from one body to the other may be hard to follow: sizes that differ by more than 3 times, or
/// boxes that do not touch; "" where neither is so.
std::string fault_of_placing(const SurfaceExtent& first, const SurfaceExtent& other);

}  // namespace interleaf
