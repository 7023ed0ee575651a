#include "family/blend_kind.h"

#include <fmt/core.h>

namespace interleaf {

std::string_view name_of(BlendKind kind) {
    return kind == BlendKind::straight ? "straight" : "turning";
}

std::optional<BlendKind> blend_kind_named(std::string_view name) {
    for (const BlendKind kind : {BlendKind::straight, BlendKind::turning})
        if (name == name_of(kind)) return kind;
    return std::nullopt;
}

std::optional<std::string> remark_on_straight(BlendKind kind, std::size_t key_count) {
    if (kind == BlendKind::straight || key_count <= Turning::max_keys) return std::nullopt;
    return fmt::format("Parts turn in blends of at most {} keys; this one has {} and is straight.",
                       Turning::max_keys, key_count);
}

void set_blend(UnionMesh& mesh, BlendKind kind, std::size_t first) {
    mesh.turning.reset();
    if (turns(kind, mesh.key_count() - first)) mesh.turning.emplace(mesh, first);
}

}  // namespace interleaf
