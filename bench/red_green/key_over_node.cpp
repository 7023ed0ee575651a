#include "key_over_node.h"

#include <vector>

namespace interleaf::bench {
namespace {

/// Barycentric coordinates in the parent of the corners of child \p child, one column per corner.
glm::dmat3 corners_of_child(unsigned child) {
    glm::dmat3 corners(0);
    for (unsigned d = 0; d < 3; ++d) {
        const auto column = static_cast<int>(d);
        const int next = (column + 1) % 3;
        const int last = (column + 2) % 3;
        if (child == 3) {
            corners[column][next] = corners[column][last] = 0.5;
        } else {
            corners[column][column] += 0.5;
            corners[column][static_cast<int>(child)] += 0.5;
        }
    }
    return corners;
}

KeyOverNode over_own_node(const RedGreenKey& key, Index node) {
    if (key.forest.is_split(node)) return {Lie::split, no_line, node, glm::dmat3(1)};
    return {Lie::leaf, key.forest.green_line(node), node, glm::dmat3(1)};
}

KeyOverNode over_child(const RedGreenKey& key, const KeyOverNode& parent, Index node, unsigned child) {
    if (parent.lie == Lie::split) return over_own_node(key, node);
    KeyOverNode over{parent.lie, no_line, parent.leaf, parent.corners * corners_of_child(child)};
    if (parent.lie == Lie::leaf) over.lie = Lie::whole;
    if (parent.is_cut()) {
        const bool runs_on = child == parent.line || child == 3;
        over.lie = runs_on ? Lie::across : Lie::half;
        if (runs_on) over.line = parent.line;
    }
    return over;
}

class Walk {
  public:
    Walk(const RedForest& forest, std::span<const RedGreenKey> keys, const NodeVisitor& visit)
        : forest_(forest), keys_(keys), visit_(visit) {}

    void root(Index node) {
        std::vector<KeyOverNode> over;
        for (const RedGreenKey& key : keys_) over.push_back(over_own_node(key, node));
        descend(node, over);
    }

  private:
    void descend(Index node, const std::vector<KeyOverNode>& over) {
        visit_(node, over);
        if (!forest_.is_split(node)) return;
        const Index first = forest_.complex().node(node).first_child;
        std::vector<KeyOverNode> over_it(over.size());
        for (unsigned child = 0; child < 4; ++child) {
            for (std::size_t key = 0; key < over.size(); ++key)
                over_it[key] = over_child(keys_[key], over[key], first + child, child);
            descend(first + child, over_it);
        }
    }

    const RedForest& forest_;
    std::span<const RedGreenKey> keys_;
    const NodeVisitor& visit_;
};

}  // namespace

glm::dvec3 point_over(const RedGreenKey& key, const KeyOverNode& over, const glm::dvec3& b) {
    return point_in_leaf(key, over.leaf, over.corners * b);
}

void visit_nodes(const RedForest& forest, std::span<const RedGreenKey> keys, const NodeVisitor& visit) {
    Walk walk(forest, keys, visit);
    for (Index root = 0; root < forest.complex().root_count(); ++root) walk.root(root);
}

}  // namespace interleaf::bench
