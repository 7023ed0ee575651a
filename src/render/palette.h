// Colors by level and by origin. The shader and the legend both use them, so they agree. No GL.
//
// Levels use the lighter part of viridis (color_map.h), so that shading stays visible. Where many leaves have nearly
// the same level, their levels get larger steps of color. Keys use the colors of Okabe and Ito (2008), which
// color-blind people can distinguish. A set of keys has the mean color of its keys; the set of all active keys is
// neutral.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "hierarchy/color.h"
#include "hierarchy/union_mesh.h"

namespace interleaf {

/// Color of a surface without coloring, sRGB-encoded.
inline constexpr glm::vec3 plain_color{0.84F, 0.81F, 0.77F};

/// Smallest and largest level of the leaves of a mesh.
struct LevelRange {
    unsigned min = 0;
    unsigned max = 0;

    /// The place of each level in the color map, ascending from 0 to 1; even steps if there are none.
    std::vector<float> places{};

    bool operator==(const LevelRange&) const = default;
};

/// The places of levels in the color map, from the number of leaves of each level.
std::vector<float> level_places(std::span<const std::size_t> leaves);

/// The range, with places by the number of leaves.
LevelRange level_range(const UnionMesh& mesh);

/// The sets of keys that occur as origin of a leaf of \p mesh, ascending.
std::vector<KeySet> origins_of(const UnionMesh& mesh);

/// Color of a leaf of \p level, sRGB-encoded, components 0 to 1.
glm::vec3 level_color(unsigned level, const LevelRange& range);

/// Color of the key with index \p key in its family, sRGB-encoded. There are seven colors, which then repeat.
glm::vec3 key_color(std::size_t key);

/// Color of a leaf that is a node in the keys of \p origin, sRGB-encoded.
/// \param keys  index in the family of each active key
glm::vec3 origin_color(KeySet origin, std::span<const std::size_t> keys);

/// How many of the active keys have a leaf as a node.
enum class Share : std::uint8_t { all, some, one };

/// \param key_count  number of active keys
Share share_of(KeySet origin, std::size_t key_count);

/// Color of a leaf that \p share of the active keys have as a node, sRGB-encoded.
glm::vec3 common_color(Share share);

}  // namespace interleaf
