#include "hierarchy/union_mesh.h"

#include <algorithm>
#include <numeric>
#include <type_traits>

#include <fmt/core.h>

#include "hierarchy/checker.h"
#include "hierarchy/error.h"

namespace interleaf {

namespace {

/// The read position in a key's streams, and the write position of its part of the union.
struct Cursor {
    const std::uint64_t* bits;
    const Index* next_midpoint;  ///< vertex of the next bisected node
    const glm::vec3* positions;
    glm::vec3* stream;    ///< positions in the union
    Index* own_vertices;  ///< number in the union of each vertex of the key
    std::size_t node;     ///< next in the preorder
    Index next_vertex;    ///< the vertex that the next first visit meets
    KeySet bit;

    /// 1 if the next node is bisected, 0 if it is a leaf.
    std::size_t take_bit() {
        const std::size_t position = node++;
        return bits[position / 64] >> (position % 64) & 1;
    }
};

/// The walk over the nodes of the union. A node is alive in the keys in which it is a node; the streams of
/// the other keys pause. The buffers of the mesh have room for the largest possible union.
class UnionWalk {
  public:
    UnionWalk(std::span<Cursor> cursors, UnionMesh& mesh)
        : cursors_(cursors),
          triangles_(mesh.triangles.data()),
          tags_(mesh.tags.data()),
          origins_(mesh.origins.data()),
          vertices_(mesh.vertices.data()),
          vertex_count_(mesh.roots.vertex_count()),
          alive_(cursors.size() * (max_level + 2)) {}

    void run(std::span<const Triangle> roots) {
        for (std::size_t key = 0; key < cursors_.size(); ++key) alive_[key] = &cursors_[key];
        for (const auto& [i, j, k] : roots)
            dispatch(i, j, k, LeafTag(0, 0b111, {0, 0, 0}), alive_.data(), cursors_.size());
    }

    std::size_t leaf_count() const { return leaf_count_; }
    std::size_t vertex_count() const { return vertex_count_; }

  private:
    /// A list length that the compiler knows.
    template <std::size_t length>
    using Fixed = std::integral_constant<std::size_t, length>;

    /// Visits a node. The loops over short lists are unrolled. If the keys are refined in different places,
    /// most nodes of their union are alive in a single key.
    void dispatch(Index i, Index j, Index k, LeafTag tag, Cursor** alive, std::size_t count) {
        switch (count) {
            case 1:
                return visit_alone(i, j, k, tag, *alive[0]);
            case 2:
                return visit(i, j, k, tag, alive, Fixed<2>());
            case 3:
                return visit(i, j, k, tag, alive, Fixed<3>());
            default:
                return visit(i, j, k, tag, alive, count);
        }
    }

    /// Visits the node (i, j, k), which is alive in the keys alive[0 .. count). The array continues with room
    /// for the lists of its descendants.
    template <typename Count>
    void visit(Index i, Index j, Index k, LeafTag tag, Cursor** alive, Count count) {
        Cursor** const bisected = alive + count;
        std::size_t bisected_count = 0;
        KeySet origin = 0;
        for (std::size_t n = 0; n < count; ++n) {
            origin |= alive[n]->bit;
            bisected[bisected_count] = alive[n];
            bisected_count += alive[n]->take_bit();
        }
        if (bisected_count == 0) return add_leaf({i, j, k}, tag, origin);
        const auto tags = tag.children();
        if (bisected_count == count) {
            const Index l = take_midpoint(j, k, alive, count);
            visit(l, k, i, tags[0], alive, count);
            visit(l, i, j, tags[1], alive, count);
        } else {
            const Index l = take_midpoint(j, k, bisected, bisected_count);
            dispatch(l, k, i, tags[0], bisected, bisected_count);
            dispatch(l, i, j, tags[1], bisected, bisected_count);
        }
    }

    /// Visits a node that is alive in one key, without a list.
    void visit_alone(Index i, Index j, Index k, LeafTag tag, Cursor& alive) {
        if (alive.take_bit() == 0) return add_leaf({i, j, k}, tag, alive.bit);
        Cursor* bisected = &alive;
        const Index l = take_midpoint(j, k, &bisected, Fixed<1>());
        const auto tags = tag.children();
        visit_alone(l, k, i, tags[0], alive);
        visit_alone(l, i, j, tags[1], alive);
    }

    void add_leaf(const Triangle& leaf, LeafTag tag, KeySet origin) {
        triangles_[leaf_count_] = leaf;
        tags_[leaf_count_] = tag;
        origins_[leaf_count_] = origin;
        ++leaf_count_;
    }

    /// The same keys are bisected on both sides of an edge, and all of them meet its midpoint here for the
    /// first time, or all for the second time. So any one of them tells whether the union has the vertex
    /// already, and which vertex it is.
    template <typename Count>
    Index take_midpoint(Index a, Index b, Cursor** bisected, Count count) {
        const Index own = *bisected[0]->next_midpoint;
        const bool is_new = own == bisected[0]->next_vertex;
        for (std::size_t n = 0; n < count; ++n) ++bisected[n]->next_midpoint;
        return is_new ? add_midpoint(a, b, bisected, count) : bisected[0]->own_vertices[own];
    }

    template <typename Count>
    Index add_midpoint(Index a, Index b, Cursor** bisected, Count count) {
        const Index midpoint = vertex_count_++;
        for (const Cursor& cursor : cursors_)
            cursor.stream[midpoint] = (cursor.stream[a] + cursor.stream[b]) * 0.5F;
        KeySet owners = 0;
        for (std::size_t n = 0; n < count; ++n) {
            Cursor& cursor = *bisected[n];
            const Index own = cursor.next_vertex++;
            cursor.own_vertices[own] = midpoint;
            cursor.stream[midpoint] = cursor.positions[own];
            owners |= cursor.bit;
        }
        vertices_[midpoint] = {{a, b}, owners};
        return midpoint;
    }

    std::span<Cursor> cursors_;
    Triangle* triangles_;
    LeafTag* tags_;
    KeySet* origins_;
    VertexOrigin* vertices_;
    std::size_t leaf_count_ = 0;
    Index vertex_count_;
    std::vector<Cursor*> alive_;  ///< a stack: the cursors alive at each level
};

/// Gives the buffers their largest possible size: every leaf, and every midpoint, of the union is one of some
/// key.
void make_room(std::span<const Hierarchy* const> keys, UnionMesh& mesh) {
    std::size_t vertex_bound = 0;
    std::size_t leaf_bound = 0;
    for (const Hierarchy* key : keys) {
        vertex_bound += key->vertex_count();
        leaf_bound += key->leaf_count();
    }
    if (vertex_bound >= no_index || leaf_bound >= no_index)
        throw InputError("the keys are too large to be united");
    mesh.triangles.resize(leaf_bound);
    mesh.tags.resize(leaf_bound);
    mesh.origins.resize(leaf_bound);
    mesh.vertices.resize(vertex_bound);
    mesh.positions.resize(keys.size());
    mesh.own_vertices.resize(keys.size());
    for (std::size_t key = 0; key < keys.size(); ++key) {
        mesh.positions[key].resize(vertex_bound);
        mesh.own_vertices[key].resize(keys[key]->vertex_count());
    }
}

/// Writes the root vertices, which every key owns.
void start_with_roots(std::span<const Hierarchy* const> keys, UnionMesh& mesh) {
    const Index count = mesh.roots.vertex_count();
    KeySet all = 0;
    for (std::size_t key = 0; key < keys.size(); ++key) {
        all |= key_bit(key);
        std::copy_n(keys[key]->positions.begin(), count, mesh.positions[key].begin());
        std::iota(mesh.own_vertices[key].begin(), mesh.own_vertices[key].begin() + count, Index{0});
    }
    std::fill_n(mesh.vertices.begin(), count, VertexOrigin{{no_index, no_index}, all});
}

}  // namespace

UnionMesh unite(std::span<const Hierarchy* const> keys) {
    UnionMesh mesh;
    unite(keys, mesh);
    return mesh;
}

void unite(std::span<const Hierarchy* const> keys, UnionMesh& mesh) {
    if (keys.empty()) throw InputError("a union needs at least one key");
    if (const auto violations = check_constraints(keys); !violations.empty()) throw InputError(violations[0]);
    mesh.roots = keys[0]->roots;
    mesh.fields.clear();
    mesh.turning.reset();
    make_room(keys, mesh);
    start_with_roots(keys, mesh);

    std::vector<Cursor> cursors;
    cursors.reserve(keys.size());
    for (std::size_t key = 0; key < keys.size(); ++key)
        cursors.push_back({keys[key]->bits.data(), keys[key]->midpoints.data(), keys[key]->positions.data(),
                           mesh.positions[key].data(), mesh.own_vertices[key].data(), 0,
                           mesh.roots.vertex_count(), key_bit(key)});
    UnionWalk walk(cursors, mesh);
    walk.run(mesh.roots.triangles());

    mesh.triangles.resize(walk.leaf_count());
    mesh.tags.resize(walk.leaf_count());
    mesh.origins.resize(walk.leaf_count());
    mesh.vertices.resize(walk.vertex_count());
    for (Buffer<glm::vec3>& stream : mesh.positions) stream.resize(walk.vertex_count());
}

}  // namespace interleaf
