#include "hierarchy/detail/view_mesh.h"

#include <array>
#include <cassert>
#include <cstddef>

#include <glm/common.hpp>

#include "hierarchy/color.h"
#include "hierarchy/morph.h"
#include "hierarchy/vertex_normals.h"

namespace interleaf {

namespace {

/// Writes the leaves in preorder, and numbers the vertices by their first visit.
class LeafWriter {
  public:
    LeafWriter(const RefinedView& view, std::size_t key_count, ViewMesh& result)
        : view_(view), key_count_(key_count), result_(result), number_(view.vertices.size(), no_index) {
        UnionMesh& mesh = result.mesh;
        mesh.triangles.clear();
        mesh.tags.clear();
        mesh.origins.clear();
        mesh.vertices.clear();
        mesh.triangles.reserve(view.leaf_count);
        mesh.tags.reserve(view.leaf_count);
        mesh.origins.reserve(view.leaf_count);
        mesh.vertices.reserve(view.vertices.size());
        result.own.clear();
        result.own.reserve(view.own.size());
        result.growth.clear();
        result.growth.reserve(view.vertices.size());
    }

    void write() {
        for (Index v = 0; v < result_.mesh.roots.vertex_count(); ++v) add_vertex(v);
        KeySet all = 0;
        for (std::size_t key = 0; key < key_count_; ++key) all |= key_bit(key);
        const auto roots = static_cast<Index>(result_.mesh.roots.triangle_count());
        for (Index root = 0; root < roots; ++root) visit(root, LeafTag(0, 0b111, {0, 0, 0}), all);
    }

  private:
    /// \param origin  the keys in which \p node is a node
    void visit(Index node, LeafTag tag, KeySet origin) {
        const RefinedView::Node& at = view_.nodes[node];
        if (at.first_child == no_index) {
            const auto [i, j, k] = at.vertices;
            result_.mesh.triangles.push_back({number_[i], number_[j], number_[k]});
            result_.mesh.tags.push_back(tag);
            result_.mesh.origins.push_back(origin);
            return;
        }
        if (number_[at.midpoint] == no_index) add_vertex(at.midpoint);
        KeySet bisected = 0;
        for (std::size_t key = 0; key < key_count_; ++key)
            if (view_.places[node * key_count_ + key] != no_index) bisected |= key_bit(key);
        const auto tags = tag.children();
        visit(at.first_child, tags[0], bisected);
        visit(at.first_child + 1, tags[1], bisected);
    }

    void add_vertex(Index made) {
        number_[made] = static_cast<Index>(result_.mesh.vertices.size());
        const std::array<Index, 2>& edge = view_.vertices[made].edge;
        KeySet owners = 0;
        for (std::size_t key = 0; key < key_count_; ++key) {
            const Index own = view_.own[made * key_count_ + key];
            if (own != no_index) owners |= key_bit(key);
            result_.own.push_back(own);
        }
        VertexOrigin origin{{no_index, no_index}, owners};
        if (edge[0] != no_index) origin.edge = {number_[edge[0]], number_[edge[1]]};
        result_.mesh.vertices.push_back(origin);
        result_.growth.push_back(view_.growth(made));
    }

    const RefinedView& view_;
    std::size_t key_count_;
    ViewMesh& result_;
    std::vector<Index> number_;
};

/// The position of each vertex on key \p key.
void grow_positions(const ViewMesh& view, const Hierarchy& hierarchy, std::size_t key, std::size_t key_count,
                    Buffer<glm::vec3>& stream) {
    stream.resize(view.mesh.vertex_count());
    for (std::size_t v = 0; v < stream.size(); ++v) {
        const Index own = view.own[v * key_count + key];
        const auto& [a, b] = view.mesh.vertices[v].edge;
        if (a == no_index) {
            stream[v] = hierarchy.positions[own];
            continue;
        }
        const glm::vec3 middle = (stream[a] + stream[b]) * 0.5F;
        const float growth = view.growth[v];
        if (own == no_index)
            stream[v] = middle;
        else  // exactly its own position in the end
            stream[v] =
                growth < 1 ? glm::mix(middle, hierarchy.positions[own], growth) : hierarchy.positions[own];
    }
}

/// Flat triangles give the same sums however they are bisected, so the normals elsewhere change continuously
/// when a vertex comes. Its own normal starts as the mean that was seen at its place before.
void grow_normals(ViewMesh& view) {
    for (std::size_t v = 0; v < view.normals.size(); ++v) {
        const float growth = view.growth[v];
        if (growth >= 1) continue;
        const auto& [a, b] = view.mesh.vertices[v].edge;
        view.normals[v] = glm::mix((view.normals[a] + view.normals[b]) * 0.5F, view.normals[v], growth);
    }
}

}  // namespace

void view_mesh(const RefinedView& view, std::span<const Hierarchy* const> keys,
               std::span<const float> weights, ViewMesh& result) {
    result.mesh.roots = keys[0]->roots;
    result.mesh.own_vertices.clear();
    result.mesh.fields.clear();
    LeafWriter(view, keys.size(), result).write();
    result.mesh.positions.resize(keys.size());
    for (std::size_t key = 0; key < keys.size(); ++key)
        grow_positions(result, *keys[key], key, keys.size(), result.mesh.positions[key]);
    morph(result.mesh, weights, result.positions);
    surface_normals(result.mesh, weights, result.positions, result.normals);
    grow_normals(result);
}

UnionField view_field(const ViewMesh& view, std::span<const Hierarchy* const> keys,
                      std::span<const float> weights, const FieldName& label) {
    const std::size_t width = component_count(label.kind);
    const std::size_t vertices = view.mesh.vertex_count();
    UnionField united{label, {}};
    Buffer<float>& blend = united.values.emplace_back();
    blend.assign(width * vertices, 0.0F);
    std::vector<float> stream(width * vertices);
    for (std::size_t key = 0; key < keys.size(); ++key) {
        const Field* const field = find_field(keys[key]->fields, label);
        assert(field != nullptr);
        for (std::size_t v = 0; v < vertices; ++v) {
            const Index own = view.own[v * keys.size() + key];
            std::array<float, 3> at{};
            if (own != no_index) {
                const auto values = field->at(own);
                if (label.kind == FieldKind::color) {
                    const glm::vec3 light = linear_light({values[0], values[1], values[2]});
                    at = {light.r, light.g, light.b};
                } else {
                    at[0] = values[0];
                }
            }
            const auto& [a, b] = view.mesh.vertices[v].edge;
            const float growth = own == no_index ? 0 : view.growth[v];
            for (std::size_t c = 0; c < width; ++c) {
                float& value = stream[width * v + c];
                value = at[c];
                if (growth < 1)
                    value = glm::mix(0.5F * (stream[width * a + c] + stream[width * b + c]), value, growth);
                blend[width * v + c] += weights[key] * value;
            }
        }
    }
    return united;
}

}  // namespace interleaf
