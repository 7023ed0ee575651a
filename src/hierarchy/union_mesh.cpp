#include "hierarchy/union_mesh.h"

#include <algorithm>

#include <fmt/core.h>

#include "hierarchy/checker.h"
#include "hierarchy/error.h"

namespace interleaf {

namespace {

/// Where a key's stream stands.
struct Cursor {
    const Hierarchy* key;
    KeySet bit;
    Index* own_vertices;   ///< where each vertex of the key is in the union
    std::size_t position;  ///< of the next node in the preorder
    std::size_t midpoint;  ///< of the next bisected node's midpoint
    Index next_vertex;     ///< the vertex that the next first visit meets

    bool read_bit() { return key->is_bisected(position++); }
};

/// The walk over the nodes of the union. A node is alive in the keys in which it is a node; the streams of
/// the others stand still.
class Walk {
  public:
    Walk(std::span<Cursor> cursors, UnionMesh& mesh) : cursors_(cursors), mesh_(mesh) {
        alive_.resize(cursors.size() * (max_level + 2));
    }

    void run() {
        for (std::size_t key = 0; key < cursors_.size(); ++key) alive_[key] = &cursors_[key];
        for (const Triangle& root : mesh_.roots.triangles())
            visit(root, LeafTag(0, 0b111, {0, 0, 0}), alive_.data(), cursors_.size());
    }

  private:
    /// \p alive, \p alive_count: the cursors of the keys alive here; behind them is room for those of the
    /// children
    void visit(const Triangle& node, LeafTag tag, Cursor** alive, std::size_t alive_count) {
        Cursor** const bisected = alive + alive_count;
        std::size_t bisected_count = 0;
        KeySet origin = 0;
        for (std::size_t n = 0; n < alive_count; ++n) {
            origin |= alive[n]->bit;
            bisected[bisected_count] = alive[n];
            if (alive[n]->read_bit()) ++bisected_count;
        }
        if (bisected_count == 0) {
            mesh_.triangles.push_back(node);
            mesh_.tags.push_back(tag);
            mesh_.origins.push_back(origin);
            return;
        }
        const Index midpoint = take_midpoint(node, bisected, bisected_count);
        const auto children = bisect(node, midpoint);
        const auto tags = child_tags(tag);
        visit(children[0], tags[0], bisected, bisected_count);
        visit(children[1], tags[1], bisected, bisected_count);
    }

    /// The keys bisected at an edge are the same on both sides of it, and each of them meets its midpoint
    /// there for the first or for the second time; so any one of them tells whether the union has the vertex,
    /// and which it is.
    Index take_midpoint(const Triangle& node, Cursor** bisected, std::size_t bisected_count) {
        const Cursor& witness = *bisected[0];
        const Index own = witness.key->midpoints[witness.midpoint];
        const bool is_new = own == witness.next_vertex;
        const Index midpoint = is_new ? add_midpoint(node[1], node[2]) : witness.own_vertices[own];
        if (is_new)
            for (std::size_t n = 0; n < bisected_count; ++n) set_own_position(*bisected[n], midpoint);
        for (std::size_t n = 0; n < bisected_count; ++n) ++bisected[n]->midpoint;
        return midpoint;
    }

    Index add_midpoint(Index a, Index b) {
        const auto midpoint = static_cast<Index>(mesh_.vertices.size());
        mesh_.vertices.push_back({{a, b}, 0});
        for (std::vector<glm::vec3>& stream : mesh_.positions)
            stream.push_back((stream[a] + stream[b]) * 0.5F);
        return midpoint;
    }

    void set_own_position(Cursor& cursor, Index midpoint) {
        const Index own = cursor.next_vertex++;
        const auto key = static_cast<std::size_t>(&cursor - cursors_.data());
        cursor.own_vertices[own] = midpoint;
        mesh_.vertices[midpoint].keys |= cursor.bit;
        mesh_.positions[key][midpoint] = cursor.key->positions[own];
    }

    std::span<Cursor> cursors_;
    UnionMesh& mesh_;
    std::vector<Cursor*> alive_;  ///< a stack: at each level the cursors alive there
};

void start(std::span<const Hierarchy* const> keys, UnionMesh& mesh) {
    std::size_t vertex_bound = 0;
    std::size_t leaf_bound = 0;
    KeySet all = 0;
    for (std::size_t key = 0; key < keys.size(); ++key) {
        vertex_bound += keys[key]->vertex_count();
        leaf_bound += keys[key]->leaf_count();
        all |= key_bit(key);
    }
    mesh.roots = keys[0]->roots;
    mesh.triangles.clear();
    mesh.triangles.reserve(leaf_bound);
    mesh.tags.clear();
    mesh.tags.reserve(leaf_bound);
    mesh.origins.clear();
    mesh.origins.reserve(leaf_bound);
    const Index root_vertex_count = mesh.roots.vertex_count();
    mesh.vertices.reserve(vertex_bound);
    mesh.vertices.assign(root_vertex_count, {{no_index, no_index}, all});
    mesh.positions.resize(keys.size());
    mesh.own_vertices.resize(keys.size());
    for (std::size_t key = 0; key < keys.size(); ++key) {
        const auto& positions = keys[key]->positions;
        mesh.positions[key].reserve(vertex_bound);
        mesh.positions[key].assign(positions.begin(), positions.begin() + root_vertex_count);
        mesh.own_vertices[key].resize(positions.size());
        for (Index v = 0; v < root_vertex_count; ++v) mesh.own_vertices[key][v] = v;
    }
}

}  // namespace

std::array<LeafTag, 2> child_tags(LeafTag parent) {
    const auto edge = [&](unsigned corner) { return static_cast<unsigned>(parent.on_root_edge(corner)); };
    const unsigned level = parent.level() + 1;
    const unsigned jk = edge(0);
    const unsigned ki = edge(1);
    const unsigned ij = edge(2);
    // Opposite the vertices of (l, k, i) and (l, i, j) lie the edges (ki, il, lk) and (ij, jl, li).
    return {LeafTag(level, ki | jk << 2, {level, parent.corner_exponent(2) + 1, parent.corner_exponent(0)}),
            LeafTag(level, ij | jk << 1, {level, parent.corner_exponent(0), parent.corner_exponent(1) + 1})};
}

UnionMesh unite(std::span<const Hierarchy* const> keys) {
    UnionMesh mesh;
    unite(keys, mesh);
    return mesh;
}

void unite(std::span<const Hierarchy* const> keys, UnionMesh& mesh) {
    if (keys.empty()) throw InputError("a union needs at least one key");
    if (const auto violations = check_constraints(keys); !violations.empty()) throw InputError(violations[0]);
    start(keys, mesh);
    std::vector<Cursor> cursors;
    for (std::size_t key = 0; key < keys.size(); ++key)
        cursors.push_back(
            {keys[key], key_bit(key), mesh.own_vertices[key].data(), 0, 0, mesh.roots.vertex_count()});
    Walk(cursors, mesh).run();
}

}  // namespace interleaf
