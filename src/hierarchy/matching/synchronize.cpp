#include "hierarchy/matching/synchronize.h"

#include <algorithm>
#include <cassert>
#include <span>
#include <utility>
#include <vector>

namespace interleaf {

namespace {

/// Where the tree of a root begins in the preorder.
struct TreeBegin {
    std::size_t node;
    std::size_t midpoint;
};

/// One entry per root, and one for the end of the last tree.
std::vector<TreeBegin> tree_begins(const Hierarchy& key) {
    std::vector<TreeBegin> begins;
    begins.reserve(key.roots.triangle_count() + std::size_t{1});
    TreeBegin at{0, 0};
    for (Index root = 0; root < key.roots.triangle_count(); ++root) {
        begins.push_back(at);
        for (std::size_t open = 1; open > 0;) {  // number of nodes of the tree that are still to come
            const bool is_bisected = key.is_bisected(at.node++);
            at.midpoint += is_bisected ? 1 : 0;
            open = is_bisected ? open + 1 : open - 1;
        }
    }
    begins.push_back(at);
    return begins;
}

/// Writes the trees of \p key in the order of \p roots. Midpoints keep the key's numbers.
void copy_trees(const Hierarchy& key, std::span<const Index> roots, Hierarchy& result) {
    const std::vector<TreeBegin> begins = tree_begins(key);
    result.bits.assign(key.bits.size(), 0);
    result.midpoints.reserve(key.midpoints.size());
    std::size_t node = 0;
    for (const Index root : roots) {
        const TreeBegin& begin = begins[root];
        const TreeBegin& end = begins[root + std::size_t{1}];
        for (std::size_t from = begin.node; from < end.node; ++from, ++node)
            result.bits[node / 64] |= std::uint64_t{key.is_bisected(from)} << (node % 64);
        const auto midpoint = [&](const TreeBegin& tree) {
            return key.midpoints.begin() + static_cast<std::ptrdiff_t>(tree.midpoint);
        };
        result.midpoints.insert(result.midpoints.end(), midpoint(begin), midpoint(end));
    }
}

/// Numbers midpoints by their first visit, after the root vertices.
/// \return the key's number of each vertex, by new number
std::vector<Index> renumber_vertices(const std::vector<Index>& root_vertices, std::size_t vertex_count,
                                     Buffer<Index>& midpoints) {
    std::vector<Index> sources = root_vertices;
    sources.reserve(vertex_count);
    std::vector<Index> number(vertex_count, no_index);
    for (Index& midpoint : midpoints) {
        if (number[midpoint] == no_index) {
            number[midpoint] = static_cast<Index>(sources.size());
            sources.push_back(midpoint);
        }
        midpoint = number[midpoint];
    }
    assert(sources.size() == vertex_count);
    return sources;
}

/// The elements of \p values at the indices \p sources, in that order.
template <typename Values>
Values reordered(const Values& values, std::span<const Index> sources) {
    Values result;
    result.reserve(sources.size());
    for (const Index source : sources) result.push_back(values[source]);
    return result;
}

}  // namespace

Hierarchy with_roots_of(const RootComplex& roots, const Hierarchy& key, const RootMatch& match) {
    Hierarchy result;
    result.roots = roots;
    copy_trees(key, match.roots, result);
    const std::vector<Index> sources =
        renumber_vertices(match.vertices, key.vertex_count(), result.midpoints);
    result.positions = reordered(key.positions, sources);
    for (const Field& field : key.fields) result.fields.push_back(renumbered(field, sources));
    return result;
}

RootComplex with_marking_of(const RootComplex& roots, const RootComplex& key, const RootMatch& match) {
    std::vector<Triangle> triangles(roots.triangles().begin(), roots.triangles().end());
    for (std::size_t root = 0; root < triangles.size(); ++root) {
        Triangle& triangle = triangles[root];
        const Index first = key.triangles()[match.roots[root]][0];
        const auto* const place = std::find_if(triangle.begin(), triangle.end(),
                                               [&](Index vertex) { return match.vertices[vertex] == first; });
        assert(place != triangle.end());
        std::rotate(triangle.begin(), triangle.begin() + (place - triangle.begin()), triangle.end());
    }
    return {roots.vertex_count(), std::move(triangles)};
}

}  // namespace interleaf
