#include "hierarchy/field.h"

#include <algorithm>

#include "text/characters.h"

namespace interleaf {

bool is_field_name(std::string_view text) {
    return !text.empty() && text.size() <= max_field_name && is_printable(text);
}

std::vector<FieldName> labels(std::span<const Field> fields) {
    std::vector<FieldName> result;
    result.reserve(fields.size());
    for (const Field& field : fields) result.push_back(field.label());
    return result;
}

Field renumbered(const Field& field, std::span<const Index> vertices) {
    Field result{field.name, field.kind, {}};
    result.values.reserve(component_count(field.kind) * vertices.size());
    for (const Index vertex : vertices) {
        const std::span<const float> values = field.at(vertex);
        result.values.insert(result.values.end(), values.begin(), values.end());
    }
    return result;
}

const Field* find_field(std::span<const Field> fields, const FieldName& label) {
    const auto found =
        std::ranges::find_if(fields, [&](const Field& field) { return field.label() == label; });
    return found == fields.end() ? nullptr : &*found;
}

}  // namespace interleaf
