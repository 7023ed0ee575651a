// The meshes of the offer to fit, as tiles side by side. Each tile shows a picture of the mesh inside a globe
// that carries the edges of the roots.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "render/camera.h"

namespace interleaf {

/// The camera for a picture of a mesh in the unit ball around the origin, with the globe around the mesh.
Camera tile_camera();

struct FitTile {
    std::string name;
    std::string remark;    ///< size of the mesh, below the name
    unsigned picture = 0;  ///< drawn with tile_camera(), transparent around the mesh; 0 if there is none yet
    std::string fault;     ///< why there is no picture, in its place; empty while the picture is being made
    std::vector<std::array<glm::vec3, 2>> root_edges;  ///< directions of their ends, after the turn
    int axis = 1;                                      ///< axis of the turn: 0, 1, 2 for x, y, z
    bool is_turned = false;
    glm::vec3 center{0};  ///< center of the globe, in the unit ball that the tile shows
    float radius = 1;     ///< radius of the globe, in that ball
};

struct FitTilesResult {
    std::optional<std::size_t> clicked;
};

/// Shows as many of \p tiles, from \p first on, as fit into a row, centered in the current window. Arrow
/// buttons lead to the other tiles.
/// \param first  changed so that \p selected is visible
/// \param side  side of the pictures
FitTilesResult fit_tiles(std::span<const FitTile> tiles, std::size_t selected, std::size_t& first, float side,
                         bool has_focus);

/// The possible sides of pictures, ascending, at scale 1.
inline constexpr std::array<float, 3> tile_sides{104, 152, 224};

/// Height of a tile with a picture of this side, including the text below.
float tile_height(float side);

}  // namespace interleaf
