#include "fit/mesh/half_edge_mesh.h"

#include <fmt/core.h>

#include "hierarchy/error.h"

namespace interleaf {
namespace {

/// The half-edges, sorted by origin: those from vertex v are at places first[v] to first[v + 1].
struct HalfEdgesByOrigin {
    std::vector<Index> first;
    std::vector<Index> half_edges;

    HalfEdgesByOrigin(Index vertex_count, std::span<const Index> origin)
        : first(vertex_count + 1), half_edges(origin.size()) {
        for (const Index vertex : origin) ++first[vertex + 1];
        for (Index vertex = 0; vertex < vertex_count; ++vertex) first[vertex + 1] += first[vertex];
        std::vector<Index> place(first.begin(), first.end() - 1);
        for (Index half_edge = 0; half_edge < origin.size(); ++half_edge)
            half_edges[place[origin[half_edge]]++] = half_edge;
    }
};

[[noreturn]] void throw_bad_edge(Index from, Index to) {
    throw InputError(fmt::format(
        "the edge between vertices {} and {} does not belong to two triangles that run along it in opposite "
        "directions",
        from, to));
}

}  // namespace

HalfEdgeMesh::HalfEdgeMesh(Index vertex_count, std::span<const Triangle> triangles)
    : twin_(3 * triangles.size(), no_index),
      outgoing_(vertex_count, no_index),
      degree_(vertex_count),
      has_triangle_(triangles.size(), 1) {
    origin_.reserve(3 * triangles.size());
    for (const Triangle& triangle : triangles) {
        for (const Index vertex : triangle)
            if (vertex >= vertex_count)
                throw InputError(
                    fmt::format("a triangle names vertex {}, but there are {}", vertex, vertex_count));
        origin_.insert(origin_.end(), triangle.begin(), triangle.end());
    }
    const HalfEdgesByOrigin sorted(vertex_count, origin_);
    std::vector<Index> to_target(vertex_count, no_index);  // from the present vertex
    for (Index vertex = 0; vertex < vertex_count; ++vertex) {
        const std::span<const Index> from_vertex(sorted.half_edges.data() + sorted.first[vertex],
                                                 sorted.half_edges.data() + sorted.first[vertex + 1]);
        if (from_vertex.empty()) throw InputError(fmt::format("no triangle uses vertex {}", vertex));
        for (const Index half_edge : from_vertex) {
            Index& known = to_target[target(half_edge)];
            if (known != no_index && origin_[known] == vertex) throw_bad_edge(vertex, target(half_edge));
            known = half_edge;
        }
        for (const Index half_edge : from_vertex) {
            const Index inward = previous(half_edge);
            const Index outward = to_target[origin_[inward]];
            if (outward == no_index || origin_[outward] != vertex) throw_bad_edge(vertex, origin_[inward]);
            twin_[inward] = outward;
            twin_[outward] = inward;
        }
        outgoing_[vertex] = from_vertex.front();
        degree_[vertex] = static_cast<Index>(from_vertex.size());
    }
    for (Index vertex = 0; vertex < vertex_count; ++vertex) check_fan(vertex);
}

void HalfEdgeMesh::check_fan(Index vertex) const {
    Index count = 0;
    Index half_edge = outgoing_[vertex];
    do {
        ++count;
        half_edge = rotated(half_edge);
    } while (half_edge != outgoing_[vertex]);
    if (count != degree_[vertex])
        throw InputError(fmt::format("the surface touches itself at vertex {}", vertex));
}

bool HalfEdgeMesh::is_connected() const {
    std::vector<char> is_reached(triangle_capacity());
    std::vector<Index> waiting = {0};
    is_reached[0] = 1;
    Index count = 0;
    while (!waiting.empty()) {
        const Index triangle = waiting.back();
        waiting.pop_back();
        ++count;
        for (Index k = 0; k < 3; ++k) {
            const Index neighbor = twin_[3 * triangle + k] / 3;
            if (is_reached[neighbor]) continue;
            is_reached[neighbor] = 1;
            waiting.push_back(neighbor);
        }
    }
    return count == triangle_capacity();
}

void HalfEdgeMesh::collapse(Index half_edge) {
    const Index opposite = twin_[half_edge];
    const Index kept = origin_[opposite];
    const Index left_kept = twin_[next(half_edge)];         // x to w, in front of the triangle (v, w, x)
    const Index left_removed = twin_[previous(half_edge)];  // v to x
    const Index right_removed = twin_[next(opposite)];      // y to v, in front of the triangle (w, v, y)
    const Index right_kept = twin_[previous(opposite)];     // w to y

    degree_[kept] += degree_[origin_[half_edge]] - 4;
    --degree_[origin_[left_kept]];
    --degree_[origin_[right_removed]];
    outgoing_[origin_[half_edge]] = no_index;
    outgoing_[kept] = left_removed;
    outgoing_[origin_[left_kept]] = left_kept;
    outgoing_[origin_[right_removed]] = right_removed;
    for (Index fan = left_removed; fan != next(opposite); fan = rotated(fan)) origin_[fan] = kept;

    twin_[left_kept] = left_removed;
    twin_[left_removed] = left_kept;
    twin_[right_removed] = right_kept;
    twin_[right_kept] = right_removed;
    has_triangle_[half_edge / 3] = 0;
    has_triangle_[opposite / 3] = 0;
}

void HalfEdgeMesh::undo_collapse(Index half_edge) {
    const Index opposite = twin_[half_edge];
    for (const Index inner : {next(half_edge), previous(half_edge), next(opposite), previous(opposite)})
        twin_[twin_[inner]] = inner;

    const Index vertex = origin_[half_edge];
    for (Index fan = rotated(half_edge); fan != next(opposite); fan = rotated(fan)) origin_[fan] = vertex;
    degree_[origin_[opposite]] -= degree_[vertex] - 4;
    ++degree_[origin_[previous(half_edge)]];
    ++degree_[origin_[previous(opposite)]];
    outgoing_[vertex] = half_edge;
    outgoing_[origin_[opposite]] = opposite;
    has_triangle_[half_edge / 3] = 1;
    has_triangle_[opposite / 3] = 1;
}

bool HalfEdgeMesh::are_joined(Index a, Index b) const {
    if (degree_[a] > degree_[b]) std::swap(a, b);
    Index half_edge = outgoing_[a];
    do {
        if (target(half_edge) == b) return true;
        half_edge = rotated(half_edge);
    } while (half_edge != outgoing_[a]);
    return false;
}

void HalfEdgeMesh::flip(Index half_edge) {
    const Index opposite = twin_[half_edge];
    const Index b_to_c = next(half_edge);
    const Index c_to_a = previous(half_edge);
    const Index a_to_d = next(opposite);
    const Index d_to_b = previous(opposite);
    const Index a = origin_[half_edge];
    const Index b = origin_[opposite];
    const Index c = origin_[c_to_a];
    const Index d = origin_[d_to_b];
    const Index before_bc = twin_[b_to_c];
    const Index before_ca = twin_[c_to_a];
    const Index before_ad = twin_[a_to_d];
    const Index before_db = twin_[d_to_b];

    // The triangles become d c a and c d b. The half-edges keep their order in the triangles.
    origin_[half_edge] = d;
    origin_[b_to_c] = c;
    origin_[c_to_a] = a;
    origin_[opposite] = c;
    origin_[a_to_d] = d;
    origin_[d_to_b] = b;
    join(b_to_c, before_ca);
    join(c_to_a, before_ad);
    join(a_to_d, before_db);
    join(d_to_b, before_bc);
    outgoing_[a] = c_to_a;
    outgoing_[b] = d_to_b;
    outgoing_[c] = opposite;
    outgoing_[d] = half_edge;
    --degree_[a];
    --degree_[b];
    ++degree_[c];
    ++degree_[d];
}

Index HalfEdgeMesh::split(Index half_edge) {
    const Index opposite = twin_[half_edge];
    const Index b_to_c = next(half_edge);
    const Index d_to_b = previous(opposite);
    const Index b = origin_[opposite];
    const Index c = origin_[previous(half_edge)];
    const Index d = origin_[d_to_b];
    const Index before_bc = twin_[b_to_c];
    const Index before_db = twin_[d_to_b];
    const Index middle = vertex_capacity();
    const Index first = 3 * triangle_capacity();  // of the triangle middle b c
    const Index second = first + 3;               // of the triangle b middle d

    origin_.insert(origin_.end(), {middle, b, c, b, middle, d});
    twin_.resize(twin_.size() + 6);
    has_triangle_.resize(has_triangle_.size() + 2, 1);
    origin_[b_to_c] = middle;
    origin_[opposite] = middle;
    join(first, second);
    join(first + 1, before_bc);
    join(first + 2, b_to_c);
    join(second + 1, d_to_b);
    join(second + 2, before_db);
    outgoing_.push_back(first);
    outgoing_[b] = second;
    degree_.push_back(4);
    ++degree_[c];
    ++degree_[d];
    return middle;
}

}  // namespace interleaf
