#include "io/mesh/ply_properties.h"

#include <algorithm>
#include <array>
#include <string_view>

#include <fmt/core.h>

namespace interleaf {

namespace {

constexpr std::array<std::string_view, 3> components = {"red", "green", "blue"};

/// \p text as a word of a PLY header: '_' replaces everything but ASCII letters and digits.
std::string word(std::string_view text) {
    std::string result(text);
    for (char& c : result)
        if (!((c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9'))) c = '_';
    return result;
}

/// \p name, with a number appended if the name is taken by a coordinate, a color or an earlier property.
std::string free_name(const std::string& name, std::span<const PlyProperty> properties) {
    const auto is_taken = [&](std::string_view candidate) {
        constexpr std::array<std::string_view, 6> reserved = {"x", "y", "z", "red", "green", "blue"};
        return std::ranges::find(reserved, candidate) != reserved.end() ||
               std::ranges::find(properties, candidate, &PlyProperty::name) != properties.end();
    };
    std::string result = name;
    for (std::size_t number = 2; is_taken(result); ++number) result = fmt::format("{}_{}", name, number);
    return result;
}

}  // namespace

std::vector<PlyProperty> ply_properties(std::span<const Field> fields, const Field* vertex_colors,
                                        std::span<const FieldScale> scales) {
    std::vector<PlyProperty> properties;
    for (const Field& field : fields) {
        if (field.kind == FieldKind::scalar) {
            properties.push_back({free_name(word(field.name), properties), false, &field, 0,
                                  scale_of(scales, field.name).offset});
            continue;
        }
        for (std::size_t c = 0; c < components.size(); ++c) {
            const std::string component(components[c]);
            properties.push_back({&field == vertex_colors
                                      ? component
                                      : free_name(word(field.name) + "_" + component, properties),
                                  true, &field, c});
        }
    }
    return properties;
}

}  // namespace interleaf
