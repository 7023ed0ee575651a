// Meshes that may be fitted, as tiles side by side: each a picture of the mesh with the roots around it, as
// a globe that carries their edges.
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

/// From where a mesh in the unit ball about the origin is seen, with the globe around it.
Camera tile_camera();

struct FitTile {
    std::string name;
    std::string remark;    ///< below the name: how large it is
    unsigned picture = 0;  ///< by tile_camera(), with nothing where the mesh is not; 0 for none yet
    std::string fault;     ///< in place of the picture: why there is none; empty while it is being made
    std::vector<std::array<glm::vec3, 2>> root_edges;  ///< their ends as directions, where they lie
    int axis = 1;                                      ///< that it is turned about: 0, 1, 2 for x, y, z
    bool is_turned = false;
    glm::vec3 center{0};  ///< of the globe, in the unit ball that the tile shows
    float radius = 1;     ///< of the globe
};

struct FitTilesResult {
    std::optional<std::size_t> clicked;
};

/// As many of \p tiles, from \p first on, as have room in a row; \p first is moved so that \p selected is
/// among them; arrows lead to the others. The row is centered in the present window.
FitTilesResult fit_tiles(std::span<const FitTile> tiles, std::size_t selected, std::size_t& first, float side,
                         bool has_focus);

/// Sides of the pictures that tiles have, from small to large, at scale 1.
inline constexpr std::array<float, 3> tile_sides{104, 152, 224};

/// Height of a tile with this side, with the text below it.
float tile_height(float side);

}  // namespace interleaf
