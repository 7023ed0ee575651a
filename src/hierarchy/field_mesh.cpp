#include "hierarchy/field_mesh.h"

#include <string_view>

#include <fmt/core.h>

namespace interleaf {

std::string component_name(const MeshField& field, std::size_t component) {
    constexpr std::array<std::string_view, 3> axes = {"x", "y", "z"};
    if (field.components == 1) return field.name;
    if (field.components <= axes.size()) return fmt::format("{} {}", field.name, axes[component]);
    return fmt::format("{} {}", field.name, component + 1);
}

}  // namespace interleaf
