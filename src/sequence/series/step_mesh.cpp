#include "sequence/series/step_mesh.h"

#include <algorithm>

#include <fmt/core.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "hierarchy/error.h"
#include "hierarchy/field.h"
#include "sequence/series/surface_checks.h"
#include "sequence/series/welding.h"

namespace interleaf {

namespace {

/// A mesh is flat if it is this thin, relative to its size.
constexpr double max_thickness = 1e-6;

const MeshField& point_field(const FieldMesh& mesh, const std::string& name) {
    const auto found = std::ranges::find(mesh.point_fields, name, &MeshField::name);
    if (found != mesh.point_fields.end()) return *found;
    std::string known;
    for (const MeshField& field : mesh.point_fields) known += (known.empty() ? "" : ", ") + field.name;
    throw InputError(
        fmt::format("field {} is missing; the point fields are: {}", name, known.empty() ? "none" : known));
}

void add_scalars(const MeshField& field, SeriesFields& fields) {
    for (std::size_t component = 0; component < field.components; ++component) {
        SeriesScalar scalar{field.name, component, component_name(field, component)};
        if (!is_field_name(scalar.name))
            throw InputError(fmt::format("\"{}\" cannot be the name of a field", scalar.name));
        if (std::ranges::find(fields.scalars, scalar.name, &SeriesScalar::name) != fields.scalars.end())
            throw InputError(fmt::format("two fields have the name {}", scalar.name));
        if (fields.scalars.size() == max_field_count)
            throw InputError(fmt::format("the steps have more than {} scalars; choose some fields by name",
                                         max_field_count));
        fields.scalars.push_back(std::move(scalar));
    }
}

}  // namespace

glm::dvec3 StepMesh::position(Index point) const {
    glm::dvec3 position = points[point];
    for (int axis = 0; axis < 3; ++axis)
        if (const Index scalar = displacement[static_cast<unsigned>(axis)]; scalar != no_index)
            position[axis] += values[scalar][point];
    return position;
}

SeriesFields fields_of(const FieldMesh& mesh, std::span<const std::string> names,
                       const std::string& displacement) {
    SeriesFields fields;
    if (names.empty())
        for (const MeshField& field : mesh.point_fields) add_scalars(field, fields);
    for (const std::string& name : names) add_scalars(point_field(mesh, name), fields);
    if (displacement.empty()) return fields;

    const MeshField& field = point_field(mesh, displacement);
    if (field.components < 2 || field.components > 3)
        throw InputError(fmt::format("field {} has {} components, expected two or three for a displacement",
                                     field.name, field.components));
    if (std::ranges::find(fields.scalars, field.name, &SeriesScalar::field) == fields.scalars.end())
        add_scalars(field, fields);
    for (Index scalar = 0; scalar < fields.scalars.size(); ++scalar)
        if (fields.scalars[scalar].field == field.name)
            fields.displacement[fields.scalars[scalar].component] = scalar;
    return fields;
}

StepMesh clean_step(const FieldMesh& mesh, const SeriesFields& fields, std::vector<std::string>& notes) {
    StepMesh step = weld(mesh, fields, notes);
    find_neighbors(step);
    step.hanging = hanging_vertex(step);
    orient(step);
    return step;
}

std::optional<unsigned> flat_axis(std::span<const glm::dvec3> points) {
    if (points.empty()) return std::nullopt;
    glm::dvec3 low = points[0];
    glm::dvec3 high = points[0];
    for (const glm::dvec3& point : points) {
        low = glm::min(low, point);
        high = glm::max(high, point);
    }
    const glm::dvec3 size = high - low;
    const double largest = std::max({size.x, size.y, size.z});
    for (const unsigned axis : {2U, 1U, 0U})
        if (size[static_cast<int>(axis)] <= max_thickness * largest) return axis;
    return std::nullopt;
}

glm::dvec3 area_vector(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
    return glm::cross(b - a, c - a);
}

std::string text_of(const glm::dvec3& place) {
    return fmt::format("({:g}, {:g}, {:g})", place.x, place.y, place.z);
}

}  // namespace interleaf
