#include "io/hierarchy/field_planes.h"

#include <algorithm>
#include <bit>
#include <cstdint>

#include "hierarchy/error.h"
#include "io/hierarchy/byte_planes.h"
#include "io/hierarchy/position_planes.h"

namespace interleaf {

namespace {

/// A component of a field, one number per vertex.
struct Column {
    std::size_t field;
    std::size_t component;
};

template <typename Fields, typename KindOf>
std::vector<Column> columns_of(const Fields& fields, KindOf kind_of) {
    std::vector<Column> columns;
    for (std::size_t f = 0; f < fields.size(); ++f)
        for (std::size_t c = 0; c < component_count(kind_of(fields[f])); ++c) columns.push_back({f, c});
    return columns;
}

std::size_t group_count(std::size_t column_count) {
    return (column_count + BytePlanes::columns - 1) / BytePlanes::columns;
}

/// Calls \p visit(column, axis) for the columns of group \p group, one per axis.
template <typename Visit>
void for_group(std::span<const Column> columns, std::size_t group, Visit visit) {
    const std::size_t begin = group * BytePlanes::columns;
    const std::size_t end = std::min(begin + BytePlanes::columns, columns.size());
    for (std::size_t n = begin; n < end; ++n) visit(columns[n], static_cast<int>(n - begin));
}

void require_zeros(std::span<const glm::vec3> group, int first_axis) {
    for (const glm::vec3& row : group)
        for (int axis = first_axis; axis < 3; ++axis)
            if (std::bit_cast<std::uint32_t>(row[axis]) != 0)
                throw InputError("columns that belong to no field are not zero");
}

}  // namespace

std::size_t field_planes_size(std::span<const FieldName> fields, std::size_t vertex_count) {
    const auto columns = columns_of(fields, [](const FieldName& field) { return field.kind; });
    return group_count(columns.size()) * BytePlanes::bytes_a_row * vertex_count;
}

Buffer<std::byte> field_planes(std::span<const Field> fields, const Connectivity& connectivity) {
    const auto columns = columns_of(fields, [](const Field& field) { return field.kind; });
    const std::size_t vertex_count = connectivity.levels.size();
    Buffer<std::byte> bytes;
    for (std::size_t group = 0; group < group_count(columns.size()); ++group) {
        std::vector<glm::vec3> rows(vertex_count, glm::vec3(0));
        for_group(columns, group, [&](const Column& column, int axis) {
            const Field& field = fields[column.field];
            for (std::size_t v = 0; v < vertex_count; ++v)
                rows[v][axis] = field.values[component_count(field.kind) * v + column.component];
        });
        const Buffer<std::byte> planes = position_planes(rows, connectivity, std::nullopt);
        bytes.insert(bytes.end(), planes.begin(), planes.end());
    }
    return bytes;
}

std::vector<Field> fields_of(std::span<std::byte> planes, std::span<const FieldName> labels,
                             const Connectivity& connectivity) {
    const auto columns = columns_of(labels, [](const FieldName& field) { return field.kind; });
    const std::size_t vertex_count = connectivity.levels.size();
    const std::size_t group_size = BytePlanes::bytes_a_row * vertex_count;
    std::vector<Field> fields;
    for (const auto& [name, kind] : labels) {
        fields.push_back({name, kind, {}});
        fields.back().values.resize(component_count(kind) * vertex_count);
    }
    for (std::size_t group = 0; group < group_count(columns.size()); ++group) {
        const Buffer<glm::vec3> rows =
            positions_of(planes.subspan(group * group_size, group_size), connectivity, std::nullopt);
        int used = 0;
        for_group(columns, group, [&](const Column& column, int axis) {
            Field& field = fields[column.field];
            for (std::size_t v = 0; v < vertex_count; ++v)
                field.values[component_count(field.kind) * v + column.component] = rows[v][axis];
            used = axis + 1;
        });
        require_zeros(rows, used);
    }
    return fields;
}

}  // namespace interleaf
