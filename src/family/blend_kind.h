// The two ways from key to key: straight, as in the paper, or turning.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
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

/// Whether parts turn in a blend of \p key_count keys. A single key, and more than Turning::max_keys keys, blend
/// straight.
constexpr bool turns(BlendKind kind, std::size_t key_count) {
    return kind == BlendKind::turning && key_count > 1 && key_count <= Turning::max_keys;
}

/// A sentence for users if \p key_count keys are too many to turn.
std::optional<std::string> remark_on_straight(BlendKind kind, std::size_t key_count);

/// Lets \p mesh blend its keys in this way, if turns() says so.
/// \param first  the first key that blends: the keys before it have the weight 0 and only refine the leaves
void set_blend(UnionMesh& mesh, BlendKind kind, std::size_t first = 0);

}  // namespace interleaf
