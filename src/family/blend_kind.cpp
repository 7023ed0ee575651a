#include "family/blend_kind.h"

namespace interleaf {

std::string_view name_of(BlendKind kind) {
    return kind == BlendKind::straight ? "straight" : "turning";
}

std::optional<BlendKind> blend_kind_named(std::string_view name) {
    for (const BlendKind kind : {BlendKind::straight, BlendKind::turning})
        if (name == name_of(kind)) return kind;
    return std::nullopt;
}

void set_blend(UnionMesh& mesh, BlendKind kind) {
    mesh.turning.reset();
    if (kind == BlendKind::turning && mesh.key_count() > 1 && mesh.key_count() <= Turning::max_keys)
        mesh.turning.emplace(mesh);
}

}  // namespace interleaf
