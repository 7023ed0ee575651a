#include "picture_family.h"

#include <utility>

#include "hierarchy/hierarchy.h"

namespace interleaf::bench {
namespace {

/// The keys, in the order of the colors that `interleaf render` gives them.
constexpr std::array<std::string_view, 4> key_names = {"across", "surface", "green", "crossing"};
constexpr std::size_t surface_key = 1;

std::size_t key_of(LeafKind kind) {
    switch (kind) {
        case LeafKind::across:
            return 0;
        case LeafKind::green:
            return 2;
        case LeafKind::crossing:
        case LeafKind::triple:
            return 3;
        default:
            return surface_key;
    }
}

/// The root triangles of all pieces, each piece with its own vertices, and the bisections of each key. New
/// vertices are numbered from 0 here; in the hierarchies, the root vertices come before them.
struct Pieces {
    struct Tree {
        std::size_t key;  ///< the key that bisects it
        Triangle root;
        std::vector<Leaf> leaves;  ///< in that key; new vertices counted from first_new
    };
    static constexpr Index first_new = 1U << 31;

    std::vector<glm::vec3> root_positions;
    std::vector<glm::vec3> displacements;  ///< of the new vertices
    std::vector<Tree> trees;

    Index add_root_vertex(const glm::vec3& position) {
        root_positions.push_back(position);
        return static_cast<Index>(root_positions.size() - 1);
    }
    Index add_new_vertex(const glm::vec3& position, Index a, Index b) {
        displacements.push_back(position - 0.5F * (root_positions[a] + root_positions[b]));
        return first_new + static_cast<Index>(displacements.size() - 1);
    }
};

void add_halved(Pieces& pieces, const PicturePiece& piece, unsigned line, Index first) {
    const Triangle root = {first + line, first + (line + 1) % 3, first + (line + 2) % 3};
    const auto [left, right] = bisect(root, pieces.add_new_vertex(piece.middles[line], root[1], root[2]));
    pieces.trees.push_back({key_of(piece.kind), root, {{left, 1}, {right, 1}}});
}

/// Adds one half of a leaf whose lines cross. \p root lies beside the line that is its refinement edge.
/// \p outer_child is the child that reaches the edge on which another line may end, at \p end.
void add_crossed_half(Pieces& pieces, const Triangle& root, Index centroid, unsigned outer_child,
                      const glm::vec3* end) {
    const auto children = bisect(root, centroid);
    std::vector<Leaf> leaves;
    for (unsigned child = 0; child < 2; ++child) {
        const Triangle& part = children[child];
        if (child != outer_child || end == nullptr) {
            leaves.push_back({part, 1});
            continue;
        }
        for (const Triangle& quarter : bisect(part, pieces.add_new_vertex(*end, part[1], part[2])))
            leaves.push_back({quarter, 2});
    }
    pieces.trees.push_back({key_of(LeafKind::crossing), root, std::move(leaves)});
}

void add_crossed(Pieces& pieces, const PicturePiece& piece, unsigned line, Index first) {
    const unsigned a = (line + 1) % 3;
    const unsigned b = (line + 2) % 3;
    const Index middle = pieces.add_root_vertex(piece.middles[line]);
    const Triangle left = {first + a, middle, first + line};
    const Triangle right = {first + b, first + line, middle};
    const Index centroid = pieces.add_new_vertex(piece.centroid, first + line, middle);
    add_crossed_half(pieces, left, centroid, 0, piece.lines[b] ? &piece.middles[b] : nullptr);
    add_crossed_half(pieces, right, centroid, 1, piece.lines[a] ? &piece.middles[a] : nullptr);
}

void add_piece(Pieces& pieces, const PicturePiece& piece) {
    const Index first = pieces.add_root_vertex(piece.corners[0]);
    pieces.add_root_vertex(piece.corners[1]);
    pieces.add_root_vertex(piece.corners[2]);
    unsigned line = 0;
    while (line < 3 && !piece.lines[line]) ++line;
    if (line == 3) {
        pieces.trees.push_back({surface_key, {first, first + 1, first + 2}, {}});
    } else if (piece.kind < LeafKind::crossing) {
        add_halved(pieces, piece, line, first);
    } else {
        add_crossed(pieces, piece, line, first);
    }
}

Hierarchy key_hierarchy(const RootComplex& roots, const Pieces& pieces, std::size_t key) {
    std::vector<Leaf> leaves;
    for (const Pieces::Tree& tree : pieces.trees) {
        if (tree.key != key || tree.leaves.empty()) {
            leaves.push_back({tree.root, 0});
            continue;
        }
        for (Leaf leaf : tree.leaves) {
            for (Index& vertex : leaf.vertices)
                if (vertex >= Pieces::first_new) vertex += roots.vertex_count() - Pieces::first_new;
            leaves.push_back(leaf);
        }
    }
    std::vector<glm::vec3> positions(roots.vertex_count(), glm::vec3(0));
    if (key == surface_key) positions = pieces.root_positions;
    positions.insert(positions.end(), pieces.displacements.begin(), pieces.displacements.end());
    return hierarchy_from_leaves(roots, leaves, positions);
}

}  // namespace

std::vector<PicturePiece> pieces_of(const Overlay& overlay, std::span<const double> weights) {
    const auto blend = [&](Index vertex) {
        glm::dvec3 sum(0);
        for (std::size_t key = 0; key < weights.size(); ++key)
            sum += weights[key] * overlay.positions[key][vertex];
        return glm::vec3(sum);
    };
    std::vector<PicturePiece> pieces;
    for (const OverlayLeaf& leaf : overlay.leaves) {
        PicturePiece piece;
        piece.kind = leaf.kind;
        for (unsigned c = 0; c < 3; ++c) {
            piece.corners[c] = blend(leaf.corners[c]);
            piece.lines[c] = leaf.middles[c] != no_index;
            if (piece.lines[c]) piece.middles[c] = blend(leaf.middles[c]);
        }
        if (leaf.centroid != no_index) piece.centroid = blend(leaf.centroid);
        pieces.push_back(piece);
    }
    return pieces;
}

std::vector<PicturePiece> pieces_of(std::span<const Triangle> triangles,
                                    std::span<const glm::vec3> positions) {
    std::vector<PicturePiece> pieces;
    for (const auto& [i, j, k] : triangles) {
        PicturePiece piece;
        piece.corners = {positions[i], positions[j], positions[k]};
        pieces.push_back(piece);
    }
    return pieces;
}

Family picture_family(std::span<const PicturePiece> pieces) {
    Pieces all;
    for (const PicturePiece& piece : pieces) add_piece(all, piece);
    std::vector<Triangle> triangles;
    triangles.reserve(all.trees.size());
    for (const Pieces::Tree& tree : all.trees) triangles.push_back(tree.root);
    const RootComplex roots(static_cast<Index>(all.root_positions.size()), std::move(triangles));
    Family family;
    family.name = "Special cases";
    for (std::size_t key = 0; key < key_names.size(); ++key)
        family.keys.push_back({std::string(key_names[key]), key_hierarchy(roots, all, key)});
    return family;
}

}  // namespace interleaf::bench
