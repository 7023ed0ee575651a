// What the colors of the surface mean, in words: for the display panel and for pictures.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "hierarchy/union_mesh.h"
#include "render/palette.h"

namespace interleaf {

/// "bone + star": the keys of \p origin.
/// \param names  of the active keys
std::string origin_name(KeySet origin, std::span<const std::string> names);

/// What a color of Coloring::common means.
struct ShareMeaning {
    Share share;
    const char* text;
    const char* explanation;
};

/// Of the shares that occur, the most common complex first.
/// \param origins    that occur
/// \param key_count  number of active keys
std::vector<ShareMeaning> share_meanings(std::span<const KeySet> origins, std::size_t key_count);

}  // namespace interleaf
