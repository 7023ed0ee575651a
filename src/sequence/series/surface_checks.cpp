#include "sequence/series/surface_checks.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <fmt/core.h>
#include <glm/geometric.hpp>

#include "hierarchy/buffer.h"
#include "hierarchy/error.h"

namespace interleaf {

namespace {

/// A side of a triangle, 3 t + k, in the list of its lower end.
struct SideAtEnd {
    Index higher_end;
    Index side;
};

std::array<Index, 2> ends_of(const StepMesh& step, Index side) {
    const Triangle& corners = step.triangles[side / 3];
    return {corners[(side + 1) % 3], corners[(side + 2) % 3]};
}

/// All sides, in lists by their lower end, each list in ascending order.
struct SideLists {
    Buffer<Index> begins;  ///< per vertex, then the number of sides
    Buffer<SideAtEnd> sides;

    explicit SideLists(const StepMesh& step)
        : begins(step.points.size() + 1, 0), sides(3 * step.triangles.size()) {
        const auto side_count = static_cast<Index>(sides.size());
        for (Index side = 0; side < side_count; ++side) ++begins[lower_end(step, side) + 1];
        for (std::size_t v = 1; v < begins.size(); ++v) begins[v] += begins[v - 1];
        Buffer<Index> places(begins.begin(), begins.end() - 1);
        for (Index side = 0; side < side_count; ++side) {
            const auto [a, b] = ends_of(step, side);
            sides[places[std::min(a, b)]++] = {std::max(a, b), side};
        }
        for (std::size_t v = 0; v + 1 < begins.size(); ++v)
            std::sort(sides.begin() + begins[v], sides.begin() + begins[v + 1],
                      [](const SideAtEnd& a, const SideAtEnd& b) {
                          return a.higher_end != b.higher_end ? a.higher_end < b.higher_end : a.side < b.side;
                      });
    }
    static Index lower_end(const StepMesh& step, Index side) {
        const auto [a, b] = ends_of(step, side);
        return std::min(a, b);
    }
};

/// Per triangle, the axes are summed with this sign.
double sign_of(bool reversed) {
    return reversed ? -1 : 1;
}

/// A component of a step: its triangles, oriented like the first one.
struct Component {
    std::vector<Index> triangles;
    bool is_closed = true;
};

/// Whether both triangles run along the common side in the same direction, as they are in the file.
bool same_direction(const StepMesh& step, Index triangle, unsigned side, Index neighbor) {
    const Index from = step.triangles[triangle][(side + 1) % 3];
    const Index to = step.triangles[triangle][(side + 2) % 3];
    const Triangle& other = step.triangles[neighbor];
    for (unsigned k = 0; k < 3; ++k)
        if (other[k] == from && other[(k + 1) % 3] == to) return true;
    return false;
}

Component flood(StepMesh& step, Index seed, std::vector<bool>& is_reached) {
    Component component{{seed}, true};
    is_reached[seed] = true;
    for (std::size_t next = 0; next < component.triangles.size(); ++next) {
        const Index triangle = component.triangles[next];
        for (unsigned side = 0; side < 3; ++side) {
            const Index neighbor = step.neighbors[triangle][side];
            if (neighbor == no_index) {
                component.is_closed = false;
                continue;
            }
            const bool reversed =
                step.is_reversed[triangle] != same_direction(step, triangle, side, neighbor);
            if (!is_reached[neighbor]) {
                is_reached[neighbor] = true;
                step.is_reversed[neighbor] = reversed;
                component.triangles.push_back(neighbor);
            } else if (step.is_reversed[neighbor] != reversed) {
                throw InputError(fmt::format("the surface cannot be oriented at {}",
                                             text_of(step.points[step.triangles[triangle][0]])));
            }
        }
    }
    return component;
}

/// Orients each triangle of a flat mesh by its own area.
/// \return whether neighbors then agree. They do unless triangles are folded over each other
bool orient_by_areas(StepMesh& step, int axis) {
    for (Index t = 0; t < step.triangles.size(); ++t) {
        const auto& [a, b, c] = step.triangles[t];
        step.is_reversed[t] = area_vector(step.points[a], step.points[b], step.points[c])[axis] < 0;
    }
    for (Index t = 0; t < step.triangles.size(); ++t)
        for (unsigned side = 0; side < 3; ++side) {
            const Index neighbor = step.neighbors[t][side];
            if (neighbor == no_index || neighbor < t) continue;
            const bool differ = step.is_reversed[t] != step.is_reversed[neighbor];
            if (differ != same_direction(step, t, side, neighbor)) return false;
        }
    return true;
}

/// Whether the orientation of \p component has to be exchanged.
bool is_inside_out(const StepMesh& step, const Component& component, std::optional<unsigned> axis) {
    double sum = 0;
    const glm::dvec3 origin = step.points[step.triangles[component.triangles[0]][0]];
    for (const Index triangle : component.triangles) {
        const auto& [a, b, c] = step.triangles[triangle];
        const double sign = sign_of(step.is_reversed[triangle]);
        const glm::dvec3 area = area_vector(step.points[a], step.points[b], step.points[c]);
        if (axis)
            sum += sign * area[static_cast<int>(*axis)];
        else if (component.is_closed)
            sum += sign * glm::dot(area, step.points[a] - origin);
        else
            sum += sign;
    }
    return sum < 0;
}

/// The number of triangles in the fan of \p start around its corner \p corner.
std::size_t fan_size(const StepMesh& step, Index start, unsigned corner) {
    const Index vertex = step.triangles[start][corner];
    std::size_t count = 1;
    for (const unsigned turn : {1U, 2U}) {
        Index last = start;
        Index triangle = step.neighbors[start][(corner + turn) % 3];
        while (triangle != no_index && triangle != start) {
            ++count;
            // Of the two sides at the vertex, one leads back.
            const Triangle& corners = step.triangles[triangle];
            Index next = no_index;
            bool has_come_back = false;
            for (unsigned k = 0; k < 3; ++k) {
                if (corners[k] == vertex) continue;
                const Index across = step.neighbors[triangle][k];
                if (across == last && !has_come_back)
                    has_come_back = true;
                else
                    next = across;
            }
            last = triangle;
            triangle = next;
        }
        if (triangle == start) return count;
    }
    return count;
}

}  // namespace

void find_neighbors(StepMesh& step) {
    step.neighbors.assign(step.triangles.size(), {no_index, no_index, no_index});
    const SideLists lists(step);
    for (std::size_t v = 0; v + 1 < lists.begins.size(); ++v)
        for (Index first = lists.begins[v], last = first; first < lists.begins[v + 1]; first = last) {
            const std::span<const SideAtEnd> sides(lists.sides);
            while (last < lists.begins[v + 1] && sides[last].higher_end == sides[first].higher_end) ++last;
            if (last - first > 2)
                throw InputError(fmt::format(
                    "{} triangles meet at the edge from {} to {}; expected at most two", last - first,
                    text_of(step.points[v]), text_of(step.points[sides[first].higher_end])));
            if (last - first < 2) continue;
            const Index a = sides[first].side;
            const Index b = sides[first + 1].side;
            step.neighbors[a / 3][a % 3] = b / 3;
            step.neighbors[b / 3][b % 3] = a / 3;
        }
    for (Index t = 0; t < step.neighbors.size(); ++t) {
        const auto& [a, b, c] = step.neighbors[t];
        if ((a != no_index && (a == b || a == c)) || (b != no_index && b == c))
            throw InputError(fmt::format("triangle {} shares two edges with another triangle", t));
    }
}

std::optional<glm::dvec3> hanging_vertex(const StepMesh& step) {
    // Around a hanging vertex, a long edge of the boundary and shorter ones begin at a common vertex, in one
    // direction.
    std::vector<std::array<Index, 2>> ends;  // both directions of each edge of the boundary
    for (Index side = 0; side < 3 * step.triangles.size(); ++side)
        if (step.neighbors[side / 3][side % 3] == no_index) {
            const auto [a, b] = ends_of(step, side);
            ends.push_back({a, b});
            ends.push_back({b, a});
        }
    std::ranges::sort(ends);
    for (std::size_t first = 0, last = 0; first < ends.size(); first = last) {
        const Index from = ends[first][0];
        while (last < ends.size() && ends[last][0] == from) ++last;
        std::span<std::array<Index, 2>> around(ends.data() + first, last - first);
        // Edges in one direction are neighbors in the order of directions, and the first one is tried with all.
        const auto direction = [&](const std::array<Index, 2>& edge) {
            return glm::normalize(step.points[edge[1]] - step.points[from]);
        };
        std::ranges::sort(around, [&](const auto& a, const auto& b) {
            const glm::dvec3 p = direction(a);
            const glm::dvec3 q = direction(b);
            return p.x != q.x ? p.x < q.x : p.y != q.y ? p.y < q.y : p.z < q.z;
        });
        for (std::size_t i = 0; i < around.size(); ++i)
            for (std::size_t j = i + 1; j < std::min(around.size(), i + 4); ++j) {
                const glm::dvec3 p = step.points[around[i][1]] - step.points[from];
                const glm::dvec3 q = step.points[around[j][1]] - step.points[from];
                const double shorter = std::min(glm::length(p), glm::length(q));
                const double longer = std::max(glm::length(p), glm::length(q));
                const double apart = glm::length(glm::cross(p, q)) / longer;
                const double tolerance = std::min(1e-9 * longer + 4 * step.rounding, 0.01 * shorter);
                if (glm::dot(p, q) <= 0 || apart > tolerance) continue;
                return step.points[glm::length(p) < glm::length(q) ? around[i][1] : around[j][1]];
            }
    }
    return std::nullopt;
}

void require_fans(const StepMesh& step) {
    std::vector<std::uint32_t> corners(step.points.size(), 0);
    for (const Triangle& triangle : step.triangles)
        for (const Index vertex : triangle) ++corners[vertex];
    std::vector<bool> is_seen(step.points.size(), false);
    for (Index t = 0; t < step.triangles.size(); ++t)
        for (unsigned k = 0; k < 3; ++k) {
            const Index vertex = step.triangles[t][k];
            if (is_seen[vertex]) continue;
            is_seen[vertex] = true;
            if (fan_size(step, t, k) != corners[vertex])
                throw InputError(fmt::format("triangles that share no edge meet at {}; expected a manifold",
                                             text_of(step.points[vertex])));
        }
}

void orient(StepMesh& step) {
    step.is_reversed.assign(step.triangles.size(), false);
    const std::optional<unsigned> axis = flat_axis(step.points);
    if (axis && orient_by_areas(step, static_cast<int>(*axis))) return;
    step.is_reversed.assign(step.triangles.size(), false);
    std::vector<bool> is_reached(step.triangles.size(), false);
    for (Index seed = 0; seed < step.triangles.size(); ++seed) {
        if (is_reached[seed]) continue;
        const Component component = flood(step, seed, is_reached);
        if (is_inside_out(step, component, axis))
            for (const Index triangle : component.triangles)
                step.is_reversed[triangle] = !step.is_reversed[triangle];
    }
}

}  // namespace interleaf
