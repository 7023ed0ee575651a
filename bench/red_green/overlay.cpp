#include "overlay.h"

#include <algorithm>
#include <array>
#include <unordered_map>

namespace interleaf::bench {
namespace {

using Lines = std::array<bool, 3>;

Lines lines_of(std::span<const KeyOverNode> over) {
    Lines lines{};
    for (const KeyOverNode& key : over)
        if (key.is_cut()) lines[key.line] = true;
    return lines;
}

LeafKind kind_of(std::span<const KeyOverNode> over, const Lines& lines) {
    switch (std::count(lines.begin(), lines.end(), true)) {
        case 0:
            return LeafKind::plain;
        case 1:
            break;
        case 2:
            return LeafKind::crossing;
        default:
            return LeafKind::triple;
    }
    const bool is_across =
        std::any_of(over.begin(), over.end(), [](const KeyOverNode& key) { return key.lie == Lie::across; });
    return is_across ? LeafKind::across : LeafKind::green;
}

/// Adds leaves and their vertices to an overlay. The keys agree on an edge of a leaf from both sides, so a
/// vertex gets its positions at its first visit.
class Builder {
  public:
    Builder(Overlay& overlay, std::span<const RedGreenKey> keys) : overlay_(overlay), keys_(keys) {}

    void add_leaf(Index node, std::span<const KeyOverNode> over) {
        RedComplex& complex = overlay_.forest.complex();
        const Lines lines = lines_of(over);
        OverlayLeaf leaf{node, kind_of(over, lines), {}, {}, no_index};
        const RedNode red = complex.node(node);
        for (unsigned c = 0; c < 3; ++c) {
            glm::dvec3 corner(0);
            corner[static_cast<int>(c)] = 1;
            const glm::dvec3 middle = 0.5 * (glm::dvec3(1) - corner);
            leaf.corners[c] = red_vertex(red.vertices[c], over, corner);
            leaf.middles[c] = lines[c] ? red_vertex(complex.midpoint(red.edges[c]), over, middle) : no_index;
        }
        if (leaf.kind >= LeafKind::crossing) {
            ++overlay_.vertices_of_no_key;
            leaf.centroid = add_vertex(over, glm::dvec3(1.0 / 3));
        }
        overlay_.leaves.push_back(leaf);
    }

  private:
    Index red_vertex(Index vertex, std::span<const KeyOverNode> over, const glm::dvec3& b) {
        const auto [place, is_new] =
            vertex_of_.try_emplace(vertex, static_cast<Index>(overlay_.vertex_count()));
        if (is_new) {
            add_vertex(over, b);
            const bool is_a_keys = vertex < root_vertices_ ||
                                   std::any_of(keys_.begin(), keys_.end(), [&](const RedGreenKey& key) {
                                       return key.forest.has_midpoint(vertex);
                                   });
            if (!is_a_keys) ++overlay_.vertices_of_no_key;
        }
        return place->second;
    }

    Index add_vertex(std::span<const KeyOverNode> over, const glm::dvec3& b) {
        for (std::size_t key = 0; key < keys_.size(); ++key)
            overlay_.positions[key].push_back(point_over(keys_[key], over[key], b));
        return static_cast<Index>(overlay_.vertex_count() - 1);
    }

    Overlay& overlay_;
    std::span<const RedGreenKey> keys_;
    Index root_vertices_ = overlay_.forest.complex().root_vertex_count();
    std::unordered_map<Index, Index> vertex_of_;  // from the red complex's vertices
};

}  // namespace

std::vector<Triangle> triangles_of(const OverlayLeaf& leaf) {
    unsigned c = 0;
    while (c < 3 && leaf.middles[c] == no_index) ++c;
    if (c == 3) return {leaf.corners};
    const Index at_c = leaf.corners[c];
    const Index at_a = leaf.corners[(c + 1) % 3];
    const Index at_b = leaf.corners[(c + 2) % 3];
    const Index middle = leaf.middles[c];
    if (leaf.centroid == no_index) return {{at_c, at_a, middle}, {at_c, middle, at_b}};

    const Index g = leaf.centroid;
    std::vector<Triangle> triangles = {{g, at_a, middle}, {g, middle, at_b}};
    const auto divide = [&](Index from, Index to, Index between) {
        if (between == no_index) {
            triangles.push_back({g, from, to});
        } else {
            triangles.push_back({g, from, between});
            triangles.push_back({g, between, to});
        }
    };
    divide(at_b, at_c, leaf.middles[(c + 1) % 3]);
    divide(at_c, at_a, leaf.middles[(c + 2) % 3]);
    return triangles;
}

Overlay overlay(std::span<const RedGreenKey> keys) {
    Overlay result{RedForest(keys.front().forest.complex()), {}, {}};
    for (const RedGreenKey& key : keys) result.forest.add(key.forest);
    result.positions.resize(keys.size());
    Builder builder(result, keys);
    visit_nodes(result.forest, keys, [&](Index node, std::span<const KeyOverNode> over) {
        if (!result.forest.is_split(node)) builder.add_leaf(node, over);
    });
    return result;
}

std::vector<Triangle> triangles_of(const Overlay& overlay) {
    std::vector<Triangle> mesh;
    for (const OverlayLeaf& leaf : overlay.leaves)
        for (const Triangle& triangle : triangles_of(leaf)) mesh.push_back(triangle);
    return mesh;
}

}  // namespace interleaf::bench
