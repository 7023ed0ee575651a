#include "family/parameter_domain.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/core.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "hierarchy/error.h"

namespace interleaf {
namespace {

using Corners = std::array<glm::dvec2, 3>;

double cross(const glm::dvec2& a, const glm::dvec2& b) {
    return a.x * b.y - a.y * b.x;
}

/// Twice the signed area.
double double_area(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
    return cross(b - a, c - a);
}

/// The corners of a triangle, counter-clockwise.
Corners oriented(Corners corners) {
    if (double_area(corners[0], corners[1], corners[2]) < 0) std::swap(corners[1], corners[2]);
    return corners;
}

/// Height over the longest edge.
double least_height(const Corners& corners) {
    double longest = 0;
    for (unsigned i = 0; i < 3; ++i) {
        longest = std::max(longest, glm::distance(corners[i], corners[(i + 1) % 3]));
    }
    return std::abs(double_area(corners[0], corners[1], corners[2])) / longest;
}

/// Whether \p point is farther than \p slack from the box of \p corners: most points are, and that is found
/// fast.
bool is_beside(const Corners& corners, const glm::dvec2& point, double slack) {
    const auto& [a, b, c] = corners;
    const glm::dvec2 low = glm::min(a, glm::min(b, c)) - slack;
    const glm::dvec2 high = glm::max(a, glm::max(b, c)) + slack;
    return point.x < low.x || point.y < low.y || point.x > high.x || point.y > high.y;
}

/// Whether an edge of \p a has all of \p points outside or at most \p slack inside. Corners
/// counter-clockwise.
bool edge_separates(const Corners& a, std::span<const glm::dvec2> points, double slack) {
    for (unsigned i = 0; i < 3; ++i) {
        const glm::dvec2 edge = a[(i + 1) % 3] - a[i];
        const double limit = slack * glm::length(edge);
        if (std::all_of(points.begin(), points.end(),
                        [&](const glm::dvec2& p) { return cross(edge, p - a[i]) <= limit; })) {
            return true;
        }
    }
    return false;
}

/// The point of a closed triangle that is nearest to a given one.
struct Nearest {
    double distance;
    glm::dvec2 at;
    glm::dvec3 barycentric;
};

Nearest nearest_on_edges(const Corners& corners, const glm::dvec2& point) {
    Nearest nearest{std::numeric_limits<double>::infinity(), {}, {}};
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3;
        const glm::dvec2& a = corners[static_cast<unsigned>(i)];
        const glm::dvec2& b = corners[static_cast<unsigned>(j)];
        const double t = glm::clamp(glm::dot(point - a, b - a) / glm::dot(b - a, b - a), 0.0, 1.0);
        const glm::dvec2 at = (1 - t) * a + t * b;
        const double distance = glm::distance(point, at);
        if (distance >= nearest.distance) continue;
        glm::dvec3 barycentric(0);
        barycentric[i] = 1 - t;
        barycentric[j] = t;
        nearest = {distance, at, barycentric};
    }
    return nearest;
}

Nearest nearest_in_triangle(const Corners& corners, const glm::dvec2& point) {
    const auto& [a, b, c] = corners;
    const glm::dvec3 areas(double_area(b, c, point), double_area(c, a, point), double_area(a, b, point));
    const glm::dvec3 barycentric = areas / double_area(a, b, c);
    if (glm::all(glm::greaterThanEqual(barycentric, glm::dvec3(0)))) {
        return {0, point, barycentric / (barycentric.x + barycentric.y + barycentric.z)};
    }
    return nearest_on_edges(corners, point);
}

Corners corners_of(std::span<const DomainVertex> vertices, const Triangle& triangle) {
    return {vertices[triangle[0]].at, vertices[triangle[1]].at, vertices[triangle[2]].at};
}

double diagonal(std::span<const DomainVertex> vertices) {
    glm::dvec2 low = vertices.front().at;
    glm::dvec2 high = low;
    for (const DomainVertex& vertex : vertices) {
        low = glm::min(low, vertex.at);
        high = glm::max(high, vertex.at);
    }
    return glm::distance(low, high);
}

/// What counts as touching, as a fraction of the domain's diagonal: far above rounding, far below a pixel.
constexpr double touching = 1e-12;

/// The least height of a triangle, as a fraction of the domain's diagonal.
constexpr double thinnest = 1e-9;

void check_vertices(std::span<const DomainVertex> vertices, std::span<const Triangle> triangles) {
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        if (!std::isfinite(vertices[i].at.x) || !std::isfinite(vertices[i].at.y)) {
            throw InputError(fmt::format("the position of domain vertex {} is not finite", i));
        }
    }
    std::vector<bool> used(vertices.size(), false);
    for (std::size_t t = 0; t < triangles.size(); ++t) {
        for (const Index vertex : triangles[t]) {
            if (vertex >= vertices.size()) {
                throw InputError(fmt::format("domain triangle {} names vertex {}, but there are only {}", t,
                                             vertex, vertices.size()));
            }
            used[vertex] = true;
        }
    }
    const auto unused = std::find(used.begin(), used.end(), false);
    if (unused != used.end()) {
        throw InputError(fmt::format("domain vertex {} belongs to no triangle", unused - used.begin()));
    }
}

/// Triangles may share vertices and edges, and nothing else: weights would jump across a vertex in an edge.
void check_triangles(std::span<const DomainVertex> vertices, std::span<const Triangle> triangles) {
    const double size = diagonal(vertices);
    std::vector<Corners> corners;
    corners.reserve(triangles.size());
    for (std::size_t t = 0; t < triangles.size(); ++t) {
        corners.push_back(oriented(corners_of(vertices, triangles[t])));
        // Negated, so that what overflows is refused, too.
        if (!(least_height(corners[t]) > thinnest * size)) {
            throw InputError(fmt::format("domain triangle {} has no area", t));
        }
        for (std::size_t other = 0; other < t; ++other) {
            if (!edge_separates(corners[t], corners[other], touching * size) &&
                !edge_separates(corners[other], corners[t], touching * size)) {
                throw InputError(fmt::format("domain triangles {} and {} overlap", other, t));
            }
        }
    }
    for (std::size_t t = 0; t < triangles.size(); ++t) {
        for (std::size_t v = 0; v < vertices.size(); ++v) {
            if (std::find(triangles[t].begin(), triangles[t].end(), v) != triangles[t].end()) continue;
            if (is_beside(corners[t], vertices[v].at, touching * size)) continue;
            if (nearest_in_triangle(corners[t], vertices[v].at).distance <= touching * size) {
                throw InputError(
                    fmt::format("domain vertex {} lies on triangle {} and is not a corner of it", v, t));
            }
        }
    }
}

}  // namespace

ParameterDomain::ParameterDomain(std::vector<DomainVertex> vertices, std::vector<Triangle> triangles)
    : vertices_(std::move(vertices)), triangles_(std::move(triangles)) {
    if (triangles_.empty()) throw InputError("the parameter domain has no triangle; it needs at least one");
    check_vertices(vertices_, triangles_);
    check_triangles(vertices_, triangles_);
}

DomainPoint ParameterDomain::locate(glm::dvec2 point, Index current) const {
    if (!std::isfinite(point.x) || !std::isfinite(point.y)) {
        throw InputError("the point of the parameter domain is not finite");
    }
    // Squares of what is larger would overflow.
    point = glm::clamp(point, -1e100, 1e100);

    Nearest nearest{std::numeric_limits<double>::infinity(), {}, {}};
    Index nearest_triangle = 0;
    for (Index t = 0; t < triangles_.size(); ++t) {
        const Nearest candidate = nearest_in_triangle(corners_of(vertices_, triangles_[t]), point);
        if (candidate.distance < nearest.distance) {
            nearest = candidate;
            nearest_triangle = t;
        }
    }
    // On a shared edge rounding decides which triangle is nearest, so all that touch count.
    const double slack = touching * diagonal(vertices_);
    const auto distance_to = [&](Index triangle) {
        return nearest_in_triangle(corners_of(vertices_, triangles_[triangle]), nearest.at).distance;
    };
    Index triangle = current;
    if (current >= triangles_.size() || distance_to(current) > slack) {
        // Far from the origin even the nearest triangle may not touch its own rounded point.
        triangle = 0;
        while (triangle < nearest_triangle && distance_to(triangle) > slack) ++triangle;
    }
    return {nearest.at, triangle,
            nearest_in_triangle(corners_of(vertices_, triangles_[triangle]), nearest.at).barycentric};
}

Weights ParameterDomain::weights(const DomainPoint& point) const {
    Weights weights;
    for (int corner = 0; corner < 3; ++corner) {
        const Index vertex = triangles_[point.triangle][static_cast<unsigned>(corner)];
        weights.push_back({vertices_[vertex].key, point.barycentric[corner]});
    }
    return sorted_weights(std::move(weights));
}

std::optional<glm::dvec2> ParameterDomain::point_of(const Weights& weights) const {
    std::vector<Index> places;
    glm::dvec2 at(0);
    double sum = 0;
    for (const Weight& weight : weights) {
        const auto has_key = [&](const DomainVertex& vertex) { return vertex.key == weight.key; };
        const auto vertex = std::find_if(vertices_.begin(), vertices_.end(), has_key);
        if (vertex == vertices_.end()) return std::nullopt;
        if (std::any_of(vertex + 1, vertices_.end(), has_key)) return std::nullopt;
        if (!(weight.value >= 0)) return std::nullopt;
        places.push_back(static_cast<Index>(vertex - vertices_.begin()));
        at += weight.value * vertex->at;
        sum += weight.value;
    }
    const auto holds_all_places = [&](const Triangle& triangle) {
        return std::all_of(places.begin(), places.end(), [&](Index place) {
            return std::find(triangle.begin(), triangle.end(), place) != triangle.end();
        });
    };
    constexpr double rounding = 1e-9;
    if (!(std::abs(sum - 1) <= rounding)) return std::nullopt;
    if (std::none_of(triangles_.begin(), triangles_.end(), holds_all_places)) return std::nullopt;
    return at;
}

}  // namespace interleaf
