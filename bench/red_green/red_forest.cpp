#include "red_forest.h"

namespace interleaf::bench {
namespace {

void set(std::vector<bool>& flags, Index index) {
    if (index >= flags.size()) flags.resize(index + 1);
    flags[index] = true;
}

}  // namespace

unsigned RedForest::green_line(Index leaf) const {
    for (unsigned corner = 0; corner < 3; ++corner)
        if (bisects(complex_->node(leaf).edges[corner])) return corner;
    return no_line;
}

void RedForest::split(Index node) {
    complex_->children(node);
    set(split_, node);
    for (const Index edge : complex_->node(node).edges) set(is_vertex_, complex_->edge(edge).midpoint);
}

bool RedForest::must_be_split(Index leaf) const {
    unsigned hanging = 0;
    for (const Index edge : complex_->node(leaf).edges) {
        if (!bisects(edge)) continue;
        const auto [first, second] = complex_->edge(edge).halves;
        if (++hanging == 2 || bisects(first) || bisects(second)) return true;
    }
    return false;
}

void RedForest::close() {
    for (bool changed = true; changed;) {
        changed = false;
        for (const Index leaf : leaves()) {
            if (!must_be_split(leaf)) continue;
            split(leaf);
            changed = true;
        }
    }
}

std::vector<Index> RedForest::leaves() const {
    std::vector<Index> found;
    std::vector<Index> pending;
    for (Index root = complex_->root_count(); root-- > 0;) pending.push_back(root);
    while (!pending.empty()) {
        const Index node = pending.back();
        pending.pop_back();
        if (!is_split(node)) {
            found.push_back(node);
            continue;
        }
        for (Index child = 4; child-- > 0;) pending.push_back(complex_->node(node).first_child + child);
    }
    return found;
}

void RedForest::add(const RedForest& other) {
    for (Index node = 0; node < other.split_.size(); ++node)
        if (other.split_[node]) split(node);
}

std::vector<Triangle> triangles_of_leaf(const RedComplex& complex, Index leaf, unsigned line) {
    const RedNode& node = complex.node(leaf);
    if (line == no_line) return {node.vertices};
    const Index from = node.vertices[line];
    const Index middle = complex.edge(node.edges[line]).midpoint;
    return {{from, node.vertices[(line + 1) % 3], middle}, {from, middle, node.vertices[(line + 2) % 3]}};
}

std::vector<Triangle> mesh_of(const RedForest& forest) {
    std::vector<Triangle> mesh;
    for (const Index leaf : forest.leaves())
        for (const Triangle& triangle : triangles_of_leaf(forest.complex(), leaf, forest.green_line(leaf)))
            mesh.push_back(triangle);
    return mesh;
}

}  // namespace interleaf::bench
