// The places of meshes in the tiles of the fit dialog: all at one scale, and placed relative to each other
// as the keys will be.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "fit/placement.h"

namespace interleaf {

/// The size and place of a mesh as in its file, with y up.
struct TileBody {
    SurfaceExtent surface;      ///< the part that a key is fitted to
    glm::dvec3 ball_center{0};  ///< of a ball that contains the whole mesh
    double ball_radius = 1;
};

/// A ball within the unit ball.
struct TilePlace {
    glm::vec3 center{0};
    float radius = 1;
};

/// The balls of the bodies after placing(), moved so that the first one's center is 0, and scaled so that all
/// lie in the unit ball.
std::vector<TilePlace> tile_places(std::span<const TileBody> bodies, const PlacingOptions& placing,
                                   const std::optional<SurfaceExtent>& reference);

}  // namespace interleaf
