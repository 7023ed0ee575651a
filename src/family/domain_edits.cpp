#include "family/domain_edits.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <utility>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "hierarchy/error.h"

namespace interleaf {

namespace {

using Vertices = std::vector<DomainVertex>;
using Triangles = std::vector<Triangle>;

Vertices vertices_of(const ParameterDomain& domain) {
    return {domain.vertices().begin(), domain.vertices().end()};
}

Triangles triangles_of(const ParameterDomain& domain) {
    return {domain.triangles().begin(), domain.triangles().end()};
}

bool has_corner(const Triangle& triangle, Index vertex) {
    return std::ranges::find(triangle, vertex) != triangle.end();
}

/// Twice the signed area of the triangle of three vertices.
double double_area(const Vertices& vertices, Index a, Index b, Index c) {
    const glm::dvec2 ab = vertices[b].at - vertices[a].at;
    const glm::dvec2 ac = vertices[c].at - vertices[a].at;
    return ab.x * ac.y - ab.y * ac.x;
}

/// \p triangle, counter-clockwise and with \p vertex first.
Triangle fan_triangle(const Vertices& vertices, Triangle triangle, Index vertex) {
    if (double_area(vertices, triangle[0], triangle[1], triangle[2]) < 0) std::swap(triangle[1], triangle[2]);
    std::ranges::rotate(triangle, std::ranges::find(triangle, vertex));
    return triangle;
}

/// A chain of neighbors of a vertex, counter-clockwise about it; closed if the chain goes all the way round.
struct Link {
    std::vector<Index> vertices;
    bool is_closed;
};

/// The neighbors of a vertex, one link per fan of triangles at it.
std::vector<Link> links_of(const Vertices& vertices, const Triangles& triangles, Index vertex) {
    std::map<Index, Index> next;
    std::map<Index, Index> previous;
    for (const Triangle& triangle : triangles) {
        if (!has_corner(triangle, vertex)) continue;
        const auto [v, a, b] = fan_triangle(vertices, triangle, vertex);
        next[a] = b;
        previous[b] = a;
    }
    std::vector<Link> links;
    const auto follow = [&](Index first) {
        Link link{.vertices = {first}, .is_closed = false};
        for (auto step = next.find(first); step != next.end(); step = next.find(link.vertices.back())) {
            const Index vertex_after = step->second;
            next.erase(step);
            link.is_closed = vertex_after == first;
            if (link.is_closed) break;
            link.vertices.push_back(vertex_after);
        }
        links.push_back(std::move(link));
    };
    std::vector<Index> starts;
    for (const auto& [from, to] : next)
        if (!previous.contains(from)) starts.push_back(from);
    for (const Index start : starts) follow(start);
    while (!next.empty()) follow(next.begin()->first);
    return links;
}

double longest_edge(const Vertices& vertices, const Triangle& triangle) {
    double longest = 0;
    for (unsigned i = 0; i < 3; ++i) {
        const glm::dvec2 from = vertices[triangle[i]].at;
        longest = std::max(longest, glm::distance(from, vertices[triangle[(i + 1) % 3]].at));
    }
    return longest;
}

/// The height up to which ParameterDomain regards a triangle as flat, in a domain of these vertices.
double flat_height(const Vertices& vertices) {
    const DomainBox box = box_of(vertices);
    return 1e-9 * glm::distance(box.low, box.high);
}

/// Whether \p vertex is inside \p ear, which is counter-clockwise, or outside by less than \p margin. With a
/// negative margin: whether the vertex is inside by more than -margin.
bool holds(const Vertices& vertices, const Triangle& ear, Index vertex, double margin) {
    for (unsigned i = 0; i < 3; ++i) {
        const Index a = ear[i];
        const Index b = ear[(i + 1) % 3];
        const double length = glm::distance(vertices[a].at, vertices[b].at);
        if (double_area(vertices, a, b, vertex) < -margin * length) return false;
    }
    return true;
}

/// Cuts ears off the polygon or chain of vertices that \p link is, the roundest first, until none is left. An
/// open chain keeps its ends.
///
/// An ear contains no other vertex of the link and, in an open chain, not \p removed. Rounding bends chains
/// of vertices on a straight line, so a vertex counts as on the line if its distance is less than the height
/// of a flat triangle.
Triangles cut_ears(const Vertices& vertices, Link link, Index removed) {
    const double flat = flat_height(vertices);
    std::vector<Index>& row = link.vertices;
    const auto ear_at = [&](std::size_t i) {
        return Triangle{row[(i + row.size() - 1) % row.size()], row[i], row[(i + 1) % row.size()]};
    };
    const auto is_ear = [&](const Triangle& ear) {
        if (double_area(vertices, ear[0], ear[1], ear[2]) <= flat * longest_edge(vertices, ear)) return false;
        // On a straight boundary, the removed vertex lies in the last ear's edge between the chain's ends.
        const double margin = row.size() == 3 ? -flat : flat;
        if (!link.is_closed && holds(vertices, ear, removed, margin)) return false;
        return std::ranges::none_of(
            row, [&](Index other) { return !has_corner(ear, other) && holds(vertices, ear, other, flat); });
    };
    const auto roundness = [&](const Triangle& ear) {
        const double longest = longest_edge(vertices, ear);
        return double_area(vertices, ear[0], ear[1], ear[2]) / (longest * longest);
    };
    Triangles ears;
    while (row.size() >= 3) {
        const std::size_t ends = link.is_closed ? 0 : 1;
        std::optional<std::size_t> best;
        for (std::size_t i = ends; i < row.size() - ends; ++i)
            if (is_ear(ear_at(i)) && (!best || roundness(ear_at(i)) > roundness(ear_at(*best)))) best = i;
        if (!best) break;
        ears.push_back(ear_at(*best));
        row.erase(row.begin() + static_cast<std::ptrdiff_t>(*best));
    }
    if (link.is_closed && row.size() >= 3)
        throw InputError("the vertex cannot be removed: its neighbors cannot be triangulated");
    return ears;
}

/// The domain without the vertices that no triangle uses; none if there are no triangles.
std::optional<ParameterDomain> domain_of_used(const Vertices& vertices, Triangles triangles) {
    if (triangles.empty()) return std::nullopt;
    std::vector<Index> new_index(vertices.size(), no_index);
    for (const Triangle& triangle : triangles)
        for (const Index corner : triangle) new_index[corner] = 0;
    Vertices used;
    for (Index v = 0; v < vertices.size(); ++v) {
        if (new_index[v] == no_index) continue;
        new_index[v] = static_cast<Index>(used.size());
        used.push_back(vertices[v]);
    }
    for (Triangle& triangle : triangles)
        for (Index& corner : triangle) corner = new_index[corner];
    return ParameterDomain(std::move(used), std::move(triangles));
}

/// An edge between two vertices, with the distance of a point from it.
struct NearEdge {
    std::array<Index, 2> ends;
    double distance;
    glm::dvec2 at;          ///< the nearest point on the edge
    std::size_t triangles;  ///< number of triangles with this edge
};

/// Every edge, nearest first.
std::vector<NearEdge> edges_by_distance(const Vertices& vertices, const Triangles& triangles,
                                        glm::dvec2 point) {
    std::map<std::array<Index, 2>, std::size_t> uses;
    for (const Triangle& t : triangles)
        for (unsigned i = 0; i < 3; ++i) {
            const auto [low, high] = std::minmax(t[i], t[(i + 1) % 3]);
            ++uses[{low, high}];
        }
    std::vector<NearEdge> edges;
    for (const auto& [ends, count] : uses) {
        const glm::dvec2 a = vertices[ends[0]].at;
        const glm::dvec2 along = vertices[ends[1]].at - a;
        const double t = std::clamp(glm::dot(point - a, along) / glm::dot(along, along), 0.0, 1.0);
        const glm::dvec2 at = a + t * along;
        edges.push_back({ends, glm::distance(point, at), at, count});
    }
    std::ranges::stable_sort(edges, {}, &NearEdge::distance);
    return edges;
}

/// Splits each triangle with the edge \p ends at the last vertex.
void split_edge(Triangles& triangles, const std::array<Index, 2>& ends, Index added) {
    const std::size_t count = triangles.size();
    for (std::size_t t = 0; t < count; ++t) {
        if (!has_corner(triangles[t], ends[0]) || !has_corner(triangles[t], ends[1])) continue;
        Triangle other = triangles[t];
        std::ranges::replace(triangles[t], ends[0], added);
        std::ranges::replace(other, ends[1], added);
        triangles.push_back(other);
    }
}

void split_triangle(Triangles& triangles, Index triangle, Index added) {
    const auto [a, b, c] = triangles[triangle];
    triangles[triangle] = {a, b, added};
    triangles.push_back({b, c, added});
    triangles.push_back({c, a, added});
}

/// Whether a triangle of \p domain loses its area or reverses its orientation when the vertices move to
/// \p moved.
bool turns_over(const ParameterDomain& domain, const Vertices& moved) {
    const Vertices vertices = vertices_of(domain);
    return std::ranges::any_of(domain.triangles(), [&](const Triangle& t) {
        const bool was_left = double_area(vertices, t[0], t[1], t[2]) > 0;
        const double area = double_area(moved, t[0], t[1], t[2]);
        return was_left ? !(area > 0) : !(area < 0);
    });
}

/// The domain with another triangle, over the nearest boundary edge for which the result is valid.
ParameterDomain extended(const Vertices& vertices, const Triangles& triangles,
                         const std::vector<NearEdge>& edges, Index added) {
    for (const NearEdge& edge : edges) {
        if (edge.triangles != 1) continue;
        Triangles with_one = triangles;
        with_one.push_back({edge.ends[0], edge.ends[1], added});
        try {
            return {vertices, std::move(with_one)};
        } catch (const InputError&) {
            continue;  // seen from behind, or another triangle is in the way
        }
    }
    throw InputError("no edge of the domain faces this point");
}

}  // namespace

ParameterDomain with_vertex_moved(const ParameterDomain& domain, Index vertex, glm::dvec2 to) {
    const glm::dvec2 from = domain.vertices()[vertex].at;
    const auto moved = [&](double part) -> std::optional<ParameterDomain> {
        Vertices vertices = vertices_of(domain);
        vertices[vertex].at = from + part * (to - from);
        if (turns_over(domain, vertices)) return std::nullopt;
        try {
            return domain.with_vertex_at(vertex, vertices[vertex].at);
        } catch (const InputError&) {
            return std::nullopt;
        }
    };
    if (auto there = moved(1)) return *std::move(there);
    constexpr int halvings = 12;
    ParameterDomain farthest = domain;
    double valid = 0;
    double invalid = 1;
    for (int i = 0; i < halvings; ++i) {
        const double middle = (valid + invalid) / 2;
        if (auto between = moved(middle)) {
            farthest = *std::move(between);
            valid = middle;
        } else {
            invalid = middle;
        }
    }
    return farthest;
}

ParameterDomain with_vertex_added(const ParameterDomain& domain, glm::dvec2 at, std::size_t key,
                                  double snap) {
    const DomainPoint place = domain.locate(at);  // also rejects a point that is not finite
    Vertices vertices = vertices_of(domain);
    Triangles triangles = triangles_of(domain);
    for (const DomainVertex& vertex : vertices)
        if (glm::distance(vertex.at, at) <= snap) throw InputError("the domain already has a vertex there");

    const std::vector<NearEdge> edges = edges_by_distance(vertices, triangles, at);
    const auto added = static_cast<Index>(vertices.size());
    const NearEdge& nearest = edges.front();
    if (nearest.distance <= snap) {
        vertices.push_back({nearest.at, key});
        split_edge(triangles, nearest.ends, added);
    } else if (glm::distance(place.at, at) > 0) {
        vertices.push_back({at, key});
        return extended(vertices, triangles, edges, added);
    } else {
        vertices.push_back({at, key});
        split_triangle(triangles, place.triangle, added);
    }
    return {std::move(vertices), std::move(triangles)};
}

std::optional<ParameterDomain> without_vertex(const ParameterDomain& domain, Index vertex) {
    const Vertices vertices = vertices_of(domain);
    Triangles triangles = triangles_of(domain);
    const std::vector<Link> links = links_of(vertices, triangles, vertex);
    std::erase_if(triangles, [&](const Triangle& triangle) { return has_corner(triangle, vertex); });
    for (const Link& link : links) {
        const Triangles ears = cut_ears(vertices, link, vertex);
        triangles.insert(triangles.end(), ears.begin(), ears.end());
    }
    return domain_of_used(vertices, std::move(triangles));
}

ParameterDomain with_vertex_key(const ParameterDomain& domain, Index vertex, std::size_t key) {
    Vertices vertices = vertices_of(domain);
    vertices[vertex].key = key;
    return {std::move(vertices), triangles_of(domain)};
}

}  // namespace interleaf
