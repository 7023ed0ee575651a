// The two ways from key to key: straight, as in the paper, or turning.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "hierarchy/union_mesh.h"

namespace interleaf {

enum class BlendKind : std::uint8_t {
    straight,  ///< the weighted sum of the positions (equation (3))
    turning,   ///< parts that turn from key to key turn on the way (turning.h)
};

/// "turning".
std::string_view name_of(BlendKind kind);

/// The kind called \p name; none when there is none.
std::optional<BlendKind> blend_kind_named(std::string_view name);

/// Lets \p mesh blend its keys in this way. A single key, and more than Turning::max_keys keys, blend straight.
void set_blend(UnionMesh& mesh, BlendKind kind);

}  // namespace interleaf
