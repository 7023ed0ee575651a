// Per-vertex fields: what a key carries besides its positions, such as a temperature or a color. A field
// follows the vertices through every operation: freezing, renumbering, the union, the morph (docs/theory.md).
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "hierarchy/buffer.h"
#include "hierarchy/triangle.h"

namespace interleaf {

/// What a field holds per vertex. The enumerator's value is the number of floats per vertex, and encodes the
/// kind in files.
enum class FieldKind : std::uint8_t {
    scalar = 1,
    color = 3,  ///< red, green, blue, sRGB-encoded, each from 0 to 1
};

/// "scalar".
constexpr std::string_view name_of(FieldKind kind) {
    return kind == FieldKind::color ? "color" : "scalar";
}

constexpr std::size_t component_count(FieldKind kind) {
    return static_cast<std::size_t>(kind);
}

/// A field's name and kind, without its values.
struct FieldName {
    std::string name;
    FieldKind kind = FieldKind::scalar;
    bool operator==(const FieldName&) const = default;
};

struct Field {
    std::string name;  ///< unique in its key; passes is_field_name()
    FieldKind kind = FieldKind::scalar;
    Buffer<float> values;  ///< finite; vertex after vertex, with the components of a vertex together

    FieldName label() const { return {name, kind}; }

    /// The values of \p vertex.
    std::span<const float> at(Index vertex) const {
        return std::span(values).subspan(component_count(kind) * vertex, component_count(kind));
    }
};

/// The limits on the number of fields per key, and on the bytes of a field name.
inline constexpr std::size_t max_field_count = 64;
inline constexpr std::size_t max_field_name = 255;

/// Whether \p text can name a field: 1 to max_field_name bytes, is_printable() (text/characters.h).
bool is_field_name(std::string_view text);

/// The names and kinds of \p fields.
std::vector<FieldName> labels(std::span<const Field> fields);

/// A copy of \p field with the values of \p vertices, in their order.
Field renumbered(const Field& field, std::span<const Index> vertices);

/// The field with the name and kind of \p label; null if there is none.
const Field* find_field(std::span<const Field> fields, const FieldName& label);

}  // namespace interleaf
