#include "sequence/series/welding.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/core.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "hierarchy/error.h"
#include "sequence/series/point_index.h"

namespace interleaf {

namespace {

/// The largest relative difference of two decimal numbers of six digits that come from about the same number.
constexpr double six_digits = 1e-6;

/// The largest number that a key holds.
constexpr double max_number = std::numeric_limits<float>::max();

bool is_small(const glm::dvec3& point) {
    return std::abs(point.x) <= max_number && std::abs(point.y) <= max_number &&
           std::abs(point.z) <= max_number;
}

void check_numbers(const FieldMesh& mesh) {
    if (mesh.triangles.empty()) throw InputError("there are no triangles");
    if (mesh.triangles.size() >= no_index / 3 || mesh.points.size() >= no_index)
        throw InputError("there are too many triangles or points");
    for (std::size_t point = 0; point < mesh.points.size(); ++point)
        if (!is_small(mesh.points[point]))
            throw InputError(fmt::format("point {} has a coordinate that is not finite", point));
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const auto& [a, b, c] = mesh.triangles[t];
        if (std::max({a, b, c}) >= mesh.points.size())
            throw InputError(fmt::format("triangle {} has the corners ({}, {}, {}), expected points below {}",
                                         t, a, b, c, mesh.points.size()));
        if (a == b || b == c || c == a)
            throw InputError(
                fmt::format("triangle {} has the corners ({}, {}, {}), expected three "
                            "different ones",
                            t, a, b, c));
    }
}

/// Sets the rounding of coordinates and the shortest edge. Edges of length 0 do not count.
void measure(const FieldMesh& mesh, StepMesh& step) {
    for (const glm::dvec3& point : mesh.points) {
        const glm::dvec3 size = glm::abs(point);
        step.rounding = std::max({step.rounding, size.x, size.y, size.z});
    }
    step.rounding *= six_digits;
    double shortest = std::numeric_limits<double>::max();
    for (const auto& [a, b, c] : mesh.triangles)
        for (const glm::dvec3& edge : {mesh.points[a] - mesh.points[b], mesh.points[b] - mesh.points[c],
                                       mesh.points[c] - mesh.points[a]})
            if (const double square = glm::dot(edge, edge); square > 0) shortest = std::min(shortest, square);
    step.shortest_edge = std::sqrt(shortest);
}

/// The number in \p step of each point of \p mesh, no_index for points that no triangle uses. Adds the points
/// to \p step.
std::vector<Index> number_points(const FieldMesh& mesh, StepMesh& step) {
    std::vector<bool> is_used(mesh.points.size(), false);
    for (const auto& corners : mesh.triangles)
        for (const Index corner : corners) is_used[corner] = true;

    const double tolerance = step.shortest_edge > 4 * step.rounding ? step.rounding : 0;
    PointIndex index(mesh.points, tolerance);
    std::vector<Index> number(mesh.points.size(), no_index);
    for (Index point = 0; point < mesh.points.size(); ++point) {
        if (!is_used[point]) continue;
        if (const Index earlier = index.find(mesh.points[point]); earlier != no_index) {
            number[point] = number[earlier];
            continue;
        }
        index.add(point);
        number[point] = static_cast<Index>(step.points.size());
        step.points.push_back(mesh.points[point]);
    }
    return number;
}

void renumber_triangles(const FieldMesh& mesh, const std::vector<Index>& number, StepMesh& step) {
    step.triangles.reserve(mesh.triangles.size());
    std::vector<bool> coincides(step.points.size(), false);
    for (const auto& corners : mesh.triangles) {
        const auto& [a, b, c] =
            step.triangles.emplace_back(Triangle{number[corners[0]], number[corners[1]], number[corners[2]]});
        if (a == b || a == c) coincides[a] = true;
        if (b == c) coincides[b] = true;
    }
    const auto count = std::count(coincides.begin(), coincides.end(), true);
    if (count == 0) return;
    const auto first =
        static_cast<std::size_t>(std::find(coincides.begin(), coincides.end(), true) - coincides.begin());
    throw InputError(
        fmt::format("coordinates have too few digits: corners of one triangle coincide in {} "
                    "places, such as {}; write more digits or binary files",
                    count, text_of(step.points[first])));
}

const MeshField& field_named(const FieldMesh& mesh, const std::string& name) {
    const auto found = std::ranges::find(mesh.point_fields, name, &MeshField::name);
    if (found == mesh.point_fields.end()) throw InputError(fmt::format("field {} is missing", name));
    return *found;
}

/// The values of \p scalar at the points of \p step.
std::vector<double> values_of(const FieldMesh& mesh, const SeriesScalar& scalar,
                              const std::vector<Index>& number, const StepMesh& step,
                              std::vector<std::string>& notes) {
    const MeshField& field = field_named(mesh, scalar.field);
    if (scalar.component >= field.components || field.values.size() != field.components * mesh.points.size())
        throw InputError(fmt::format(
            "field {} has {} components and {} values for {} points, expected at "
            "least {} components",
            field.name, field.components, field.values.size(), mesh.points.size(), scalar.component + 1));
    struct Collected {
        double first = 0;
        double sum = 0;
        double least = std::numeric_limits<double>::max();
        double most = std::numeric_limits<double>::lowest();
        std::size_t count = 0;
    };
    std::vector<Collected> collected(step.points.size());
    double least = std::numeric_limits<double>::max();
    double most = std::numeric_limits<double>::lowest();
    for (std::size_t point = 0; point < number.size(); ++point) {
        if (number[point] == no_index) continue;
        const double value = field.values[field.components * point + scalar.component];
        if (!(std::abs(value) <= max_number))
            throw InputError(fmt::format("field {} is not finite at point {}", field.name, point));
        Collected& at = collected[number[point]];
        if (at.count == 0) at.first = value;
        at.sum += value;
        at.least = std::min(at.least, value);
        at.most = std::max(at.most, value);
        ++at.count;
        least = std::min(least, value);
        most = std::max(most, value);
    }
    std::vector<double> values;
    values.reserve(collected.size());
    std::size_t differing = 0;
    double largest = 0;
    for (const Collected& at : collected) {
        const bool agree = at.most - at.least <= six_digits * (most - least);
        values.push_back(agree ? at.first : at.sum / static_cast<double>(at.count));
        if (agree) continue;
        ++differing;
        largest = std::max(largest, at.most - at.least);
    }
    if (differing > 0)
        notes.push_back(
            fmt::format("field {} has several values at {} points, which differ by up to {:g}: "
                        "the mean is taken",
                        scalar.name, differing, largest));
    return values;
}

/// Keeps the cells if some hold two triangles.
std::vector<Index> cells_of(const FieldMesh& mesh) {
    if (mesh.cell_of.size() != mesh.triangles.size()) return {};
    for (std::size_t t = 1; t < mesh.cell_of.size(); ++t)
        if (mesh.cell_of[t] == mesh.cell_of[t - 1]) return mesh.cell_of;
    return {};
}

}  // namespace

StepMesh weld(const FieldMesh& mesh, const SeriesFields& fields, std::vector<std::string>& notes) {
    check_numbers(mesh);
    StepMesh step;
    step.displacement = fields.displacement;
    step.cell_of = cells_of(mesh);
    measure(mesh, step);
    const std::vector<Index> number = number_points(mesh, step);
    renumber_triangles(mesh, number, step);
    for (const SeriesScalar& scalar : fields.scalars)
        step.values.push_back(values_of(mesh, scalar, number, step, notes));
    return step;
}

}  // namespace interleaf
