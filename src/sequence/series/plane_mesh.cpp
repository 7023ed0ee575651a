#include "sequence/series/plane_mesh.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>

namespace interleaf {

namespace {

/// Barycentric coordinates this far below 0 are roundings of 0.
constexpr double weight_rounding = 1e-12;

/// A triangle holds points outside by the rounding of files, but at most by this part of its height.
constexpr double max_relative_rounding = 0.02;

double cross(const glm::dvec2& a, const glm::dvec2& b) {
    return a.x * b.y - a.y * b.x;
}

double least_of(const glm::dvec3& weights) {
    return std::min({weights.x, weights.y, weights.z});
}

bool is_convex(const PlaneTriangle& a, const PlaneTriangle& b) {
    // The diagonal joins the two corners that both have; the quadrilateral is convex if it separates the others
    // and their connection meets it.
    for (int k = 0; k < 3; ++k) {
        const glm::dvec2 apex = a.corners[static_cast<std::size_t>(k)];
        const glm::dvec2 p = a.corners[static_cast<std::size_t>((k + 1) % 3)];
        const glm::dvec2 q = a.corners[static_cast<std::size_t>((k + 2) % 3)];
        for (std::size_t j = 0; j < 3; ++j) {
            if (b.corners[(j + 1) % 3] != q || b.corners[(j + 2) % 3] != p) continue;
            const glm::dvec2 other = b.corners[j];
            return cross(p - apex, other - apex) >= 0 && cross(other - apex, q - apex) >= 0;
        }
    }
    return false;
}

}  // namespace

double PlaneTriangle::double_area() const {
    return cross(corners[1] - corners[0], corners[2] - corners[0]);
}

glm::dvec3 PlaneTriangle::weights(const glm::dvec2& point) const {
    const auto& [a, b, c] = corners;
    const double whole = double_area();
    const double at_b = cross(point - a, c - a) / whole;
    const double at_c = cross(b - a, point - a) / whole;
    return {1 - at_b - at_c, at_b, at_c};
}

glm::dvec3 PlaneTriangle::nearest_weights(const glm::dvec2& point) const {
    const glm::dvec3 inside = weights(point);
    if (least_of(inside) >= 0) return inside;
    glm::dvec3 nearest(1, 0, 0);
    double least = std::numeric_limits<double>::max();
    for (int k = 0; k < 3; ++k) {
        const int next = (k + 1) % 3;
        const glm::dvec2 from = corners[static_cast<std::size_t>(k)];
        const glm::dvec2 edge = corners[static_cast<std::size_t>(next)] - from;
        const double part = std::clamp(glm::dot(point - from, edge) / glm::dot(edge, edge), 0.0, 1.0);
        const glm::dvec2 apart = from + part * edge - point;
        if (const double square = glm::dot(apart, apart); square < least) {
            least = square;
            nearest = glm::dvec3(0);
            nearest[k] = 1 - part;
            nearest[next] = part;
        }
    }
    return nearest;
}

bool PlaneTriangle::overlaps(const PlaneTriangle& other) const {
    const auto separates = [](const PlaneTriangle& a, const PlaneTriangle& b) {
        glm::dvec3 most(-1);
        for (const glm::dvec2& corner : b.corners) {
            const glm::dvec3 at = a.weights(corner);
            for (int k = 0; k < 3; ++k) most[k] = std::max(most[k], at[k]);
        }
        return least_of(most) <= weight_rounding;
    };
    return !separates(*this, other) && !separates(other, *this);
}

glm::dvec2 in_plane(const glm::dvec3& point, unsigned axis) {
    if (axis == 0) return {point.y, point.z};
    if (axis == 1) return {point.z, point.x};
    return {point.x, point.y};
}

PlaneMesh::PlaneMesh(const StepMesh& step, unsigned axis, std::span<const double> scales)
    : scales_(scales.begin(), scales.end()), rounding_(step.rounding) {
    const auto count = static_cast<Index>(step.triangles.size());
    triangles_.reserve(count);
    corners_.reserve(count);
    for (Index t = 0; t < count; ++t) {
        const auto& [a, b, c] = corners_.emplace_back(step.oriented(t));
        triangles_.push_back(
            {in_plane(step.points[a], axis), in_plane(step.points[b], axis), in_plane(step.points[c], axis)});
    }
    values_.resize(step.points.size() * scales_.size());
    for (std::size_t s = 0; s < scales_.size(); ++s)
        for (std::size_t p = 0; p < step.points.size(); ++p)
            values_[p * scales_.size() + s] = step.values[s][p];
    for (Index t = 1; t < step.cell_of.size(); ++t)
        if (step.cell_of[t] == step.cell_of[t - 1] && is_convex(triangles_[t - 1], triangles_[t])) {
            partner_.resize(count, no_index);
            partner_[t] = t - 1;
            partner_[t - 1] = t;
        }
}

double PlaneMesh::value(Index t, unsigned corner, std::size_t scalar) const {
    return values_[corners_[t][corner] * scales_.size() + scalar];
}

void PlaneMesh::blend(Index t, const glm::dvec3& weights, double* values) const {
    for (std::size_t s = 0; s < scales_.size(); ++s)
        values[s] = weights.x * value(t, 0, s) + weights.y * value(t, 1, s) + weights.z * value(t, 2, s);
}

double PlaneMesh::evaluate(const glm::dvec2& point, std::span<const Index> near, double* values) const {
    for (const Index t : near) {
        const glm::dvec3 weights = triangles_[t].weights(point);
        if (!(least_of(weights) >= -weight_rounding)) continue;
        blend(t, weights, values);
        return 0;
    }
    double least = std::numeric_limits<double>::infinity();
    glm::dvec3 nearest(0);
    Index at = no_index;
    for (const Index t : near) {
        const glm::dvec3 weights = triangles_[t].nearest_weights(point);
        const auto& [a, b, c] = triangles_[t].corners;
        const double distance = glm::distance(weights.x * a + weights.y * b + weights.z * c, point);
        if (!(distance < least)) continue;
        least = distance;
        nearest = weights;
        at = t;
    }
    if (at != no_index) blend(at, nearest, values);
    return least;
}

double PlaneMesh::difference(const PlaneNode& node, std::span<const Index> near, double enough) const {
    double largest = 0;
    for (const Index t : near) {
        largest = std::max(largest, difference(node, t, largest));
        if (largest > enough) break;
    }
    return largest;
}

/// The largest difference over the part of \p node that triangle \p t holds, or less if it is below \p least.
double PlaneMesh::difference(const PlaneNode& node, Index t, double least) const {
    std::array<glm::dvec3, 3> at;  // the corners of t, in barycentric coordinates of the node
    for (std::size_t i = 0; i < 3; ++i) at[i] = node.triangle.weights(triangles_[t].corners[i]);
    double largest = 0;
    for (std::size_t s = 0; s < scales_.size(); ++s) {
        // Both functions are linear over t, so their difference is, too.
        std::array<double, 3> apart{};
        for (unsigned i = 0; i < 3; ++i)
            apart[i] = scales_[s] * (value(t, i, s) - at[i].x * node.values[0][s] -
                                     at[i].y * node.values[1][s] - at[i].z * node.values[2][s]);
        if (std::max({std::abs(apart[0]), std::abs(apart[1]), std::abs(apart[2])}) <=
            std::max(least, largest))
            continue;
        for (std::size_t i = 0; i < 3; ++i) {
            if (least_of(at[i]) >= -weight_rounding) largest = std::max(largest, std::abs(apart[i]));
            const std::size_t j = (i + 1) % 3;
            for (int side = 0; side < 3; ++side) {
                const double from = at[i][side];
                const double to = at[j][side];
                if ((from < 0) == (to < 0)) continue;
                const double part = from / (from - to);
                if (least_of((1 - part) * at[i] + part * at[j]) < -weight_rounding) continue;
                largest = std::max(largest, std::abs((1 - part) * apart[i] + part * apart[j]));
            }
        }
    }
    return largest;
}

bool PlaneMesh::holds(Index t, const glm::dvec2& point) const {
    const glm::dvec3 weights = triangles_[t].weights(point);
    const auto& corners = triangles_[t].corners;
    const double area = triangles_[t].double_area();
    for (int k = 0; k < 3; ++k) {
        const auto at = static_cast<std::size_t>(k);
        const double side = glm::distance(corners[(at + 1) % 3], corners[(at + 2) % 3]);
        const double relative = std::min(max_relative_rounding, 2 * rounding_ * side / area);
        if (!(weights[k] >= -relative)) return false;
    }
    return true;
}

bool PlaneMesh::is_held(const PlaneTriangle& triangle, std::span<const Index> near) const {
    return std::ranges::any_of(near, [&](Index t) {
        const Index partner = partner_.empty() ? no_index : partner_[t];
        return std::ranges::all_of(triangle.corners, [&](const glm::dvec2& corner) {
            return holds(t, corner) || (partner != no_index && holds(partner, corner));
        });
    });
}

}  // namespace interleaf
