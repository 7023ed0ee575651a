#include "family/parameter_domain.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include <fmt/core.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

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

/// The height over the longest edge.
double min_height(const Corners& corners) {
    double longest = 0;
    for (unsigned i = 0; i < 3; ++i) {
        longest = std::max(longest, glm::distance(corners[i], corners[(i + 1) % 3]));
    }
    return std::abs(double_area(corners[0], corners[1], corners[2])) / longest;
}

DomainBox rectangle_about(const Corners& corners) {
    const auto& [a, b, c] = corners;
    return {glm::min(a, glm::min(b, c)), glm::max(a, glm::max(b, c))};
}

/// Whether an edge of \p a has each of \p points outside, or at most \p slack inside. The corners are
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

/// The point of a closed triangle that is nearest to a given point.
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
    const DomainBox box = box_of(vertices);
    return glm::distance(box.low, box.high);
}

/// Tolerance for touching, as a fraction of the domain's diagonal: far above rounding, far below a pixel.
constexpr double touching = 1e-12;

/// The minimum height of a triangle, as a fraction of the domain's diagonal.
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
                throw InputError(
                    fmt::format("domain triangle {} refers to vertex {}, but there are only {} vertices", t,
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

bool meet(const DomainBox& a, const DomainBox& b) {
    return a.low.x <= b.high.x && b.low.x <= a.high.x && a.low.y <= b.high.y && b.low.y <= a.high.y;
}

/// The numbers from 0 to \p count - 1 in ascending order of \p place_of.
template <typename PlaceOf>
std::vector<Index> sorted_by(std::size_t count, const PlaceOf& place_of) {
    std::vector<Index> order(count);
    std::iota(order.begin(), order.end(), Index{0});
    std::ranges::sort(order, {}, place_of);
    return order;
}

/// Two numbers that violate a rule, the smallest such pair; none if there is no violation.
using Misfit = std::optional<std::array<Index, 2>>;

void keep_least(Misfit& misfit, std::array<Index, 2> other) {
    misfit = misfit ? std::min(*misfit, other) : other;
}

/// The checks of a domain's triangles. They compare only objects that are near each other: those whose
/// bounding rectangles meet, found in order along x. Triangles with disjoint rectangles do not overlap, and a
/// point outside a rectangle is at least as far from the triangle in it. For n triangles of about the same
/// size, as wide as high, this takes about n^1.5 quick steps.
class TriangleChecks {
  public:
    TriangleChecks(std::span<const DomainVertex> vertices, std::span<const Triangle> triangles)
        : vertices_(vertices), triangles_(triangles), slack_(touching * diagonal(vertices)) {
        corners_.reserve(triangles.size());
        rectangles_.reserve(triangles.size());
        for (const Triangle& triangle : triangles) {
            corners_.push_back(oriented(corners_of(vertices, triangle)));
            rectangles_.push_back(rectangle_about(corners_.back()));
        }
    }

    /// The first triangle without area.
    std::optional<std::size_t> flat() const {
        const double least = thinnest * diagonal(vertices_);
        // The comparison is negated so that an overflow also counts as flat.
        const auto found = std::ranges::find_if(
            corners_, [least](const Corners& corners) { return !(min_height(corners) > least); });
        if (found == corners_.end()) return std::nullopt;
        return static_cast<std::size_t>(found - corners_.begin());
    }

    /// Two triangles that overlap, the later one first.
    Misfit overlap() const {
        Misfit misfit;
        const auto begin_of = [this](Index t) { return rectangles_[t].low.x; };
        const std::vector<Index> order = sorted_by(triangles_.size(), begin_of);
        for (std::size_t i = 0; i < order.size(); ++i) {
            const Index t = order[i];
            for (std::size_t j = i + 1; j < order.size() && begin_of(order[j]) <= rectangles_[t].high.x; ++j)
                keep_overlap(misfit, t, order[j]);
        }
        return misfit;
    }

    /// As overlap(), among the pairs in which a triangle has the corner \p vertex.
    Misfit overlap_at(Index vertex) const {
        Misfit misfit;
        for (Index t = 0; t < triangles_.size(); ++t) {
            if (!has_corner(t, vertex)) continue;
            for (Index other = 0; other < triangles_.size(); ++other)
                if (other < t || !has_corner(other, vertex)) keep_overlap(misfit, t, other);
        }
        return misfit;
    }

    /// A triangle, and a vertex on it that is not its corner.
    Misfit vertex_on_triangle() const {
        Misfit misfit;
        const auto x_of = [this](Index v) { return vertices_[v].at.x; };
        const std::vector<Index> order = sorted_by(vertices_.size(), x_of);
        for (Index t = 0; t < triangles_.size() && !misfit; ++t) {
            const double begin = rectangles_[t].low.x - slack_;
            const double end = rectangles_[t].high.x + slack_;
            for (auto v = std::ranges::lower_bound(order, begin, {}, x_of);
                 v != order.end() && x_of(*v) <= end; ++v)
                if (lies_on(*v, t)) keep_least(misfit, {t, *v});
        }
        return misfit;
    }

    /// As vertex_on_triangle(), among the pairs with \p vertex as the vertex or as a corner of the triangle.
    Misfit vertex_on_triangle_at(Index vertex) const {
        Misfit misfit;
        for (Index t = 0; t < triangles_.size(); ++t) {
            if (!has_corner(t, vertex)) {
                if (lies_on(vertex, t)) keep_least(misfit, {t, vertex});
                continue;
            }
            for (Index v = 0; v < vertices_.size(); ++v)
                if (lies_on(v, t)) keep_least(misfit, {t, v});
        }
        return misfit;
    }

  private:
    bool has_corner(Index triangle, Index vertex) const {
        return std::ranges::find(triangles_[triangle], vertex) != triangles_[triangle].end();
    }

    void keep_overlap(Misfit& misfit, Index a, Index b) const {
        const std::array<Index, 2> pair{std::max(a, b), std::min(a, b)};
        if (!meet(rectangles_[a], rectangles_[b]) || (misfit && *misfit < pair)) return;
        if (!edge_separates(corners_[a], corners_[b], slack_) &&
            !edge_separates(corners_[b], corners_[a], slack_))
            misfit = pair;
    }

    bool lies_on(Index vertex, Index triangle) const {
        const glm::dvec2 at = vertices_[vertex].at;
        const DomainBox about{at - slack_, at + slack_};
        return meet(about, rectangles_[triangle]) && !has_corner(triangle, vertex) &&
               nearest_in_triangle(corners_[triangle], at).distance <= slack_;
    }

    std::span<const DomainVertex> vertices_;
    std::span<const Triangle> triangles_;
    double slack_;
    std::vector<Corners> corners_;
    std::vector<DomainBox> rectangles_;
};

/// Triangles may share vertices and edges, and nothing else: weights would jump at a vertex inside an edge.
void require_fit(const std::optional<std::size_t>& flat, const Misfit& overlap, const Misfit& on_triangle) {
    if (flat) throw InputError(fmt::format("domain triangle {} has no area", *flat));
    if (overlap)
        throw InputError(fmt::format("domain triangles {} and {} overlap", (*overlap)[1], (*overlap)[0]));
    if (on_triangle)
        throw InputError(fmt::format("domain vertex {} lies on triangle {} and is not a corner of it",
                                     (*on_triangle)[1], (*on_triangle)[0]));
}

}  // namespace

DomainBox box_of(std::span<const DomainVertex> vertices) {
    DomainBox box{vertices.front().at, vertices.front().at};
    for (const DomainVertex& vertex : vertices) {
        box.low = glm::min(box.low, vertex.at);
        box.high = glm::max(box.high, vertex.at);
    }
    return box;
}

ParameterDomain::ParameterDomain(std::vector<DomainVertex> vertices, std::vector<Triangle> triangles)
    : vertices_(std::move(vertices)), triangles_(std::move(triangles)) {
    if (triangles_.empty()) throw InputError("the parameter domain has no triangle; it needs at least one");
    check_vertices(vertices_, triangles_);
    const TriangleChecks checks(vertices_, triangles_);
    require_fit(checks.flat(), checks.overlap(), checks.vertex_on_triangle());
}

// The checks of triangles and vertices depend on their positions and on the diagonal of the domain, which
// scales the tolerances. If the diagonal stays the same, all pairs without the moved vertex are unchanged, so
// they pass again. Most moves keep the diagonal: only moves of the outermost vertices change it.
ParameterDomain ParameterDomain::with_vertex_at(Index vertex, glm::dvec2 at) const {
    ParameterDomain moved = *this;
    moved.vertices_[vertex].at = at;
    if (diagonal(moved.vertices_) != diagonal(vertices_))
        return {std::move(moved.vertices_), std::move(moved.triangles_)};
    check_vertices(moved.vertices_, moved.triangles_);
    const TriangleChecks checks(moved.vertices_, moved.triangles_);
    require_fit(checks.flat(), checks.overlap_at(vertex), checks.vertex_on_triangle_at(vertex));
    return moved;
}

DomainPoint ParameterDomain::locate(glm::dvec2 point, Index current) const {
    if (!std::isfinite(point.x) || !std::isfinite(point.y)) {
        throw InputError("the point of the parameter domain is not finite");
    }
    // Squares of larger numbers would overflow.
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
    // On a shared edge, rounding decides which triangle is nearest. So all triangles that touch the point
    // count.
    const double slack = touching * diagonal(vertices_);
    const auto distance_to = [&](Index triangle) {
        return nearest_in_triangle(corners_of(vertices_, triangles_[triangle]), nearest.at).distance;
    };
    Index triangle = current;
    if (current >= triangles_.size() || distance_to(current) > slack) {
        // Far from the origin, even the nearest triangle may not touch its own rounded point.
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
