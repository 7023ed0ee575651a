// The color tables.
#include "render/palette.h"

#include <algorithm>
#include <array>
#include <bit>

#include "render/color_map.h"

namespace interleaf {
namespace {

/// Orange, blue, green, purple, yellow, sky blue, vermilion: adjacent colors differ clearly.
constexpr std::array<glm::vec3, 7> okabe_ito = {from_hex(0xe69f00), from_hex(0x0072b2), from_hex(0x009e73),
                                                from_hex(0xcc79a7), from_hex(0xf0e442), from_hex(0x56b4e9),
                                                from_hex(0xd55e00)};

/// Where the part of the color map for levels begins.
constexpr float darkest_level = 0.3F;

constexpr glm::vec3 shared_by_all = from_hex(0xd9d9d9);

}  // namespace

std::vector<float> level_places(std::span<const std::size_t> leaves) {
    std::vector<float> places;
    if (leaves.size() < 2) return places;
    // Each step from one level to the next is half an even step, and half the part of the leaves on both sides.
    double steps = 0;
    for (std::size_t level = 0; level + 1 < leaves.size(); ++level)
        steps += static_cast<double>(leaves[level] + leaves[level + 1]);
    places.reserve(leaves.size());
    places.push_back(0);
    double place = 0;
    for (std::size_t level = 0; level + 1 < leaves.size(); ++level) {
        const double part = steps > 0 ? static_cast<double>(leaves[level] + leaves[level + 1]) / steps : 0;
        place += (part + 1 / static_cast<double>(leaves.size() - 1)) / 2;
        places.push_back(static_cast<float>(place));
    }
    return places;
}

LevelRange level_range(const UnionMesh& mesh) {
    if (mesh.tags.empty()) return {};
    LevelRange range{.min = max_level};
    std::vector<std::size_t> counts(max_level + 1);
    for (const LeafTag tag : mesh.tags) {
        range.min = std::min(range.min, tag.level());
        range.max = std::max(range.max, tag.level());
        ++counts[tag.level()];
    }
    range.places = level_places(std::span(counts).subspan(range.min, range.max - range.min + 1));
    return range;
}

std::vector<KeySet> origins_of(const UnionMesh& mesh) {
    std::vector<KeySet> origins;  // sorted
    for (const KeySet origin : mesh.origins) {
        const auto place = std::lower_bound(origins.begin(), origins.end(), origin);
        if (place == origins.end() || *place != origin) origins.insert(place, origin);
    }
    return origins;
}

glm::vec3 level_color(unsigned level, const LevelRange& range) {
    if (range.max <= range.min) return color_at(ColorMap::viridis, 1);
    const unsigned above = std::clamp(level, range.min, range.max) - range.min;
    const float place = above < range.places.size()
                            ? range.places[above]
                            : static_cast<float>(above) / static_cast<float>(range.max - range.min);
    return color_at(ColorMap::viridis, darkest_level + (1 - darkest_level) * place);
}

glm::vec3 key_color(std::size_t key) {
    return okabe_ito[key % okabe_ito.size()];
}

glm::vec3 origin_color(KeySet origin, std::span<const std::size_t> keys) {
    std::vector<glm::vec3> colors;
    for (std::size_t i = 0; i < keys.size(); ++i)
        if ((origin & key_bit(i)) != 0) colors.push_back(key_color(keys[i]));
    if (colors.size() == 1) return colors.front();
    if (colors.empty() || colors.size() == keys.size()) return shared_by_all;
    glm::vec3 sum(0);
    for (const glm::vec3 color : colors) sum += linear_light(color);
    return encoded(sum / static_cast<float>(colors.size()));
}

Share share_of(KeySet origin, std::size_t key_count) {
    constexpr std::size_t told_apart = 32;  // further keys share a bit
    const auto count = static_cast<std::size_t>(std::popcount(origin));
    if (count >= std::min(key_count, told_apart)) return Share::all;
    return count > 1 ? Share::some : Share::one;
}

glm::vec3 common_color(Share share) {
    switch (share) {
        case Share::all:
            return shared_by_all;
        case Share::some:
            return from_hex(0x56b4e9);
        case Share::one:
            return from_hex(0xe69f00);
    }
    return shared_by_all;
}

}  // namespace interleaf
