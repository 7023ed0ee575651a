// The axis of a model that points up. Where nothing else is said it is y, and z points to the viewer.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include <glm/mat3x3.hpp>

namespace interleaf {

enum class UpAxis : std::uint8_t { x, y, z };

/// "X": in texts.
constexpr std::string_view name_of(UpAxis up) {
    return up == UpAxis::x ? "X" : up == UpAxis::y ? "Y" : "Z";
}

/// The axis with the letter \p name, of either case.
constexpr std::optional<UpAxis> up_axis_named(std::string_view name) {
    if (name == "x" || name == "X") return UpAxis::x;
    if (name == "y" || name == "Y") return UpAxis::y;
    if (name == "z" || name == "Z") return UpAxis::z;
    return std::nullopt;
}

/// Right, up and to the viewer, as columns: the rotation that takes y to \p up. It only swaps coordinates and signs.
inline glm::mat3 axes_with(UpAxis up) {
    if (up == UpAxis::x) return {{0, -1, 0}, {1, 0, 0}, {0, 0, 1}};
    if (up == UpAxis::z) return {{1, 0, 0}, {0, 0, 1}, {0, -1, 0}};
    return glm::mat3(1);
}

}  // namespace interleaf
