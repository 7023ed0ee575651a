#include "hierarchy/root_complex.h"

#include <algorithm>
#include <utility>

#include <fmt/core.h>

#include "hierarchy/error.h"

namespace interleaf {

namespace {

/// Side \p side of triangle \p triangle: the edge from \p from to \p to.
struct Side {
    Index from;
    Index to;
    Index triangle;
    unsigned side;

    std::pair<Index, Index> ends() const { return std::minmax(from, to); }
};

void require_indices(Index vertex_count, const std::vector<Triangle>& triangles) {
    if (triangles.empty()) throw InputError("there are no triangles, expected at least one");
    if (triangles.size() >= no_index) throw InputError("there are too many triangles");
    for (std::size_t t = 0; t < triangles.size(); ++t) {
        const auto& [a, b, c] = triangles[t];
        if (std::max({a, b, c}) >= vertex_count)
            throw RootError(
                fmt::format("triangle {} has the vertices ({}, {}, {}), expected indices below {}", t, a, b,
                            c, vertex_count),
                t);
        if (a == b || b == c || c == a)
            throw RootError(
                fmt::format("triangle {} has the vertices ({}, {}, {}), expected three different ones", t, a,
                            b, c),
                t);
    }
}

std::vector<Side> sides_by_ends(const std::vector<Triangle>& triangles) {
    std::vector<Side> sides;
    sides.reserve(3 * triangles.size());
    for (Index t = 0; t < triangles.size(); ++t)
        for (unsigned k = 0; k < 3; ++k)
            sides.push_back({triangles[t][(k + 1) % 3], triangles[t][(k + 2) % 3], t, k});
    std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
        return std::pair(a.ends(), a.triangle) < std::pair(b.ends(), b.triangle);
    });
    return sides;
}

std::vector<Triangle> match_sides(const std::vector<Triangle>& triangles) {
    const std::vector<Side> sides = sides_by_ends(triangles);
    std::vector<Triangle> neighbors(triangles.size(), Triangle{no_index, no_index, no_index});
    for (std::size_t first = 0, last = 0; first < sides.size(); first = last) {
        while (last < sides.size() && sides[last].ends() == sides[first].ends()) ++last;
        const Side& a = sides[first];
        if (last - first > 2)
            throw RootError(
                fmt::format(
                    "edge ({}, {}) belongs to {} triangles, {}, {} and {} among them; expected at most two",
                    a.from, a.to, last - first, a.triangle, sides[first + 1].triangle,
                    sides[first + 2].triangle),
                sides[first + 2].triangle);
        if (last - first < 2) continue;
        const Side& b = sides[first + 1];
        if (a.from == b.from)
            throw RootError(
                fmt::format("triangles {} and {} run along edge ({}, {}) in the same direction, expected a "
                            "consistent orientation",
                            a.triangle, b.triangle, a.from, a.to),
                b.triangle);
        neighbors[a.triangle][a.side] = b.triangle;
        neighbors[b.triangle][b.side] = a.triangle;
    }
    return neighbors;
}

void require_different_triangles(const std::vector<Triangle>& neighbors) {
    for (std::size_t t = 0; t < neighbors.size(); ++t) {
        const auto& [a, b, c] = neighbors[t];
        if (const Index twin = a == b || a == c ? a : b == c ? b : no_index; twin != no_index)
            throw RootError(fmt::format("triangles {} and {} have the same vertices", t, twin),
                            std::max<std::size_t>(t, twin));
    }
}

/// Walks the fan of triangles around vertex \p corner of triangle \p start, in both directions.
/// \return the number of triangles in the fan
std::size_t walk_fan(const std::vector<Triangle>& triangles, const std::vector<Triangle>& neighbors,
                     Index start, unsigned corner) {
    const Index vertex = triangles[start][corner];
    const auto corner_of = [&](Index t) {
        return static_cast<unsigned>(std::find(triangles[t].begin(), triangles[t].end(), vertex) -
                                     triangles[t].begin());
    };
    std::size_t count = 0;
    for (const unsigned turn : {1U, 2U}) {
        Index t = start;
        do {
            ++count;
            t = neighbors[t][(corner_of(t) + turn) % 3];
        } while (t != no_index && t != start);
        if (t == start) return count;
    }
    return count - 1;  // the start was counted in both directions
}

void require_one_fan_a_vertex(Index vertex_count, const std::vector<Triangle>& triangles,
                              const std::vector<Triangle>& neighbors) {
    std::vector<std::size_t> corners(vertex_count, 0);
    for (const Triangle& triangle : triangles)
        for (const Index vertex : triangle) ++corners[vertex];
    const auto unused = std::find(corners.begin(), corners.end(), std::size_t{0});
    if (unused != corners.end())
        throw InputError(fmt::format("vertex {} belongs to no triangle", unused - corners.begin()));

    std::vector<bool> seen(vertex_count, false);
    for (Index t = 0; t < triangles.size(); ++t)
        for (unsigned k = 0; k < 3; ++k) {
            const Index vertex = triangles[t][k];
            if (seen[vertex]) continue;
            seen[vertex] = true;
            if (walk_fan(triangles, neighbors, t, k) != corners[vertex])
                throw RootError(
                    fmt::format("vertex {} joins triangles that share no edge there, expected a manifold",
                                vertex),
                    t);
        }
}

}  // namespace

RootComplex::RootComplex() {
    static const auto empty = std::make_shared<const Connectivity>();
    connectivity_ = empty;
}

RootComplex::RootComplex(Index vertex_count, std::vector<Triangle> triangles) {
    require_indices(vertex_count, triangles);
    std::vector<Triangle> neighbors = match_sides(triangles);
    require_different_triangles(neighbors);
    require_one_fan_a_vertex(vertex_count, triangles, neighbors);
    Index boundary_edge_count = 0;
    for (const Triangle& sides : neighbors)
        boundary_edge_count += static_cast<Index>(std::count(sides.begin(), sides.end(), no_index));
    connectivity_ = std::make_shared<const Connectivity>(
        Connectivity{vertex_count, boundary_edge_count, std::move(triangles), std::move(neighbors)});
}

bool RootComplex::operator==(const RootComplex& other) const {
    return connectivity_ == other.connectivity_ ||
           (vertex_count() == other.vertex_count() && std::ranges::equal(triangles(), other.triangles()));
}

int RootComplex::euler_number() const {
    const auto vertices = static_cast<std::int64_t>(vertex_count());
    const auto faces = static_cast<std::int64_t>(triangle_count());
    const auto edges = (3 * faces + boundary_edge_count()) / 2;
    return static_cast<int>(vertices - edges + faces);
}

}  // namespace interleaf
