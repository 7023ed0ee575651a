// Colorings by values that the blend itself determines: angles, mean curvature, distance moved. No GL.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "hierarchy/union_mesh.h"
#include "render/color_map.h"
#include "render/display.h"

namespace interleaf {

/// What a list of values belongs to.
enum class ValuePlace : std::uint8_t { vertex, leaf };

struct SurfaceValues {
    ValuePlace place = ValuePlace::vertex;
    std::vector<float> values{};  ///< one per vertex, or per leaf
};

/// Whether \p coloring shows such values.
bool is_measured(Coloring coloring);

/// The values of a blend of \p mesh.
/// \param positions  of the blend
/// \pre  is_measured(coloring)
SurfaceValues surface_values(Coloring coloring, const UnionMesh& mesh, std::span<const glm::vec3> positions);

/// The scale of these values. Its range is that of the keys of \p mesh, so that it stays while they are
/// blended: angles from 0 to 60 degrees; mean curvatures up to the size that 95 % of the vertices stay below,
/// on either side of 0; distances up to that of the key that is farthest from the first.
/// \pre  is_measured(coloring)
ColorScale measured_scale(Coloring coloring, const UnionMesh& mesh);

}  // namespace interleaf
