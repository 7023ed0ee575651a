#include "io/gltf/vertex_welding.h"

#include <algorithm>
#include <compare>
#include <numeric>
#include <utility>
#include <vector>

namespace interleaf {

namespace {

template <typename Vector>
std::partial_ordering order_of(const Vector& a, const Vector& b) {
    if (const auto x = a.x <=> b.x; x != 0) return x;
    if (const auto y = a.y <=> b.y; y != 0) return y;
    return a.z <=> b.z;
}

/// The order of two vertices by their positions in the base, then in each target.
std::partial_ordering order_of(const GltfMesh& mesh, Index a, Index b) {
    std::partial_ordering order = order_of(mesh.positions[a], mesh.positions[b]);
    for (std::size_t t = 0; order == 0 && t < mesh.deltas.size(); ++t)
        order = order_of(mesh.deltas[t][a], mesh.deltas[t][b]);
    return order;
}

/// Keeps the elements \p kept of \p values, each of \p width numbers.
template <typename T>
void keep(std::vector<T>& values, const std::vector<Index>& kept, std::size_t width = 1) {
    std::vector<T> left;
    left.reserve(width * kept.size());
    for (const Index vertex : kept)
        for (std::size_t c = 0; c < width; ++c) left.push_back(values[width * vertex + c]);
    values = std::move(left);
}

}  // namespace

std::size_t weld_vertices(GltfMesh& mesh) {
    std::vector<Index> sorted(mesh.positions.size());
    std::iota(sorted.begin(), sorted.end(), Index{0});
    std::ranges::sort(sorted, [&mesh](Index a, Index b) {
        const auto order = order_of(mesh, a, b);
        return order == 0 ? a < b : order < 0;
    });
    std::vector<Index> first(sorted.size());
    for (std::size_t n = 0; n < sorted.size(); ++n) {
        const bool is_same = n > 0 && order_of(mesh, sorted[n - 1], sorted[n]) == 0;
        first[sorted[n]] = is_same ? first[sorted[n - 1]] : sorted[n];
    }
    for (Triangle& triangle : mesh.triangles)
        for (Index& vertex : triangle) vertex = first[vertex];
    return std::erase_if(mesh.triangles,
                         [](const Triangle& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; });
}

void drop_unused_vertices(GltfMesh& mesh) {
    std::vector<bool> is_used(mesh.positions.size(), false);
    for (const Triangle& triangle : mesh.triangles)
        for (const Index vertex : triangle) is_used[vertex] = true;
    std::vector<Index> used;
    std::vector<Index> number(is_used.size(), no_index);
    for (std::size_t v = 0; v < is_used.size(); ++v) {
        if (!is_used[v]) continue;
        number[v] = static_cast<Index>(used.size());
        used.push_back(static_cast<Index>(v));
    }
    if (used.size() == is_used.size()) return;
    for (Triangle& triangle : mesh.triangles)
        for (Index& vertex : triangle) vertex = number[vertex];
    keep(mesh.positions, used);
    for (auto& deltas : mesh.deltas) keep(deltas, used);
    for (GltfAttribute& attribute : mesh.attributes) {
        const std::size_t width = component_count(attribute.kind);
        keep(attribute.values, used, width);
        for (auto& deltas : attribute.deltas) keep(deltas, used, width);
    }
}

}  // namespace interleaf
