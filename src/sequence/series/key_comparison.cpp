#include "sequence/series/key_comparison.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/geometric.hpp>

#include "hierarchy/union_fields.h"
#include "hierarchy/union_mesh.h"

namespace interleaf {

namespace {

/// Integrals over a surface, or a part of it.
struct FrontIntegrals {
    double change = 0;            ///< of |d|
    double gradient = 0;          ///< of g
    double squared_gradient = 0;  ///< of g^2
};

/// The squared length of the gradient of the linear function that is \p at the corners \p corners.
double squared_gradient(const std::array<glm::dvec3, 3>& corners, const std::array<double, 3>& at) {
    const glm::dvec3 p = corners[1] - corners[0];
    const glm::dvec3 q = corners[2] - corners[0];
    const glm::dvec3 normal = glm::cross(p, q);
    const double along_p = at[1] - at[0];
    const double along_q = at[2] - at[0];
    const double whole = glm::dot(normal, normal);
    if (!(whole > 0)) return 0;
    return std::max(0.0, along_p * along_p * glm::dot(q, q) - 2 * along_p * along_q * glm::dot(p, q) +
                             along_q * along_q * glm::dot(p, p)) /
           whole;
}

FrontIntegrals front_integrals(const UnionMesh& both, const UnionField& field) {
    FrontIntegrals sum;
    for (const Triangle& triangle : both.triangles) {
        std::array<glm::dvec3, 3> corners{};
        std::array<double, 3> at{};
        double change = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            corners[k] = both.positions[0][triangle[k]];
            at[k] = field.values[0][triangle[k]];
            change += std::abs(field.values[1][triangle[k]] - at[k]) / 3;
        }
        const double area = glm::length(area_vector(corners[0], corners[1], corners[2])) / 2;
        const double square = squared_gradient(corners, at);
        sum.change += area * change;
        sum.gradient += area * std::sqrt(square);
        sum.squared_gradient += area * square;
    }
    return sum;
}

}  // namespace

double integral_error(const StepMesh& step, const Hierarchy& key, std::span<const double> ranges) {
    std::vector<double> differences(ranges.size(), 0);
    double whole = 0;
    for (const auto& [a, b, c] : step.triangles) {
        const double area =
            glm::length(area_vector(step.position(a), step.position(b), step.position(c))) / 2;
        whole += area;
        for (std::size_t s = 0; s < ranges.size(); ++s)
            differences[s] -= area * (step.values[s][a] + step.values[s][b] + step.values[s][c]) / 3;
    }
    for (const Leaf& leaf : leaves_of(key)) {
        const auto& [a, b, c] = leaf.vertices;
        const double area =
            glm::length(area_vector(key.positions[a], key.positions[b], key.positions[c])) / 2;
        for (std::size_t s = 0; s < ranges.size(); ++s) {
            const auto& values = key.fields[s].values;
            differences[s] += area * (double{values[a]} + values[b] + values[c]) / 3;
        }
    }
    double largest = 0;
    for (std::size_t s = 0; s < ranges.size(); ++s)
        if (ranges[s] > 0 && whole > 0)
            largest = std::max(largest, std::abs(differences[s]) / (whole * ranges[s]));
    return largest;
}

std::vector<double> moved_widths_times_range(const Hierarchy& key, const Hierarchy& next) {
    const std::array<const Hierarchy*, 2> keys = {&key, &next};
    std::vector<double> moved;
    if (key.fields.empty()) return moved;
    const UnionMesh both = unite(keys);
    moved.reserve(key.fields.size());
    for (const Field& field : key.fields) {
        const FrontIntegrals front = front_integrals(both, united_field(keys, both, field.label()));
        const double squared = front.gradient * front.gradient;
        moved.push_back(squared > 0 ? front.change * front.squared_gradient / squared : 0);
    }
    return moved;
}

double widths_of(std::span<const double> widths_times_range, std::span<const double> ranges) {
    double most = 0;
    for (std::size_t s = 0; s < widths_times_range.size(); ++s)
        if (ranges[s] > 0) most = std::max(most, widths_times_range[s] / ranges[s]);
    return most;
}

double moved_widths(const Hierarchy& key, const Hierarchy& next, std::span<const double> ranges) {
    return widths_of(moved_widths_times_range(key, next), ranges);
}

}  // namespace interleaf
