// Where meshes that may be fitted lie in the tiles of the offer: all at one scale, beside each other as the
// keys will be.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "fit/placement.h"

namespace interleaf {

/// A mesh as its file has it, with y up.
struct TileBody {
    SurfaceExtent surface;      ///< of the part that a key is fitted to
    glm::dvec3 ball_center{0};  ///< of a ball that holds all of it
    double ball_radius = 1;
};

/// A ball within the unit ball.
struct TilePlace {
    glm::vec3 center{0};
    float radius = 1;
};

/// The ball of each body after placing(), in the unit ball about the first.
/// \param reference  what sizes and places go by; the first body, if there is none
std::vector<TilePlace> tile_places(std::span<const TileBody> bodies, const PlacingOptions& placing,
                                   const std::optional<SurfaceExtent>& reference);

}  // namespace interleaf
