#include "hierarchy/hierarchy.h"

#include <cassert>
#include <numeric>
#include <utility>

namespace interleaf {

namespace {

void append_bit(Hierarchy& hierarchy, std::size_t& count, bool bisected) {
    if (count % 64 == 0) hierarchy.bits.push_back(0);
    if (bisected) hierarchy.bits.back() |= std::uint64_t{1} << (count % 64);
    ++count;
}

/// Writes bits and midpoints. The midpoints keep the vertex numbers that \p leaves use.
void write_preorder(Hierarchy& hierarchy, const std::vector<Leaf>& leaves) {
    struct OpenNode {
        std::size_t place;     ///< of its midpoint
        bool has_first_child;  ///< whether the first child is complete
        Triangle first_child;
    };
    std::vector<OpenNode> open;  // the bisected nodes above the next leaf: as many as its level
    std::size_t bit_count = 0;
    for (const Leaf& leaf : leaves) {
        while (open.size() < leaf.level) {
            append_bit(hierarchy, bit_count, true);
            open.push_back({hierarchy.midpoints.size(), false, {}});
            hierarchy.midpoints.push_back(no_index);
        }
        append_bit(hierarchy, bit_count, false);

        // A complete first child waits for its sibling; a complete second child completes its parent.
        Triangle node = leaf.vertices;
        while (!open.empty() && open.back().has_first_child) {
            assert(open.back().first_child[0] == node[0]);
            hierarchy.midpoints[open.back().place] = node[0];
            node = merge(open.back().first_child, node);
            open.pop_back();
        }
        if (!open.empty()) {
            open.back().has_first_child = true;
            open.back().first_child = node;
        }
    }
    assert(open.empty() && bit_count == hierarchy.node_count());
}

}  // namespace

std::size_t Hierarchy::byte_count() const {
    std::size_t bytes = bits.size() * sizeof(bits[0]) + midpoints.size() * sizeof(midpoints[0]) +
                        positions.size() * sizeof(positions[0]) + 2 * roots.triangles().size_bytes();
    for (const Field& field : fields) bytes += field.values.size() * sizeof(float);
    return bytes;
}

Hierarchy hierarchy_from_leaves(const RootComplex& roots, const std::vector<Leaf>& leaves,
                                std::span<const glm::vec3> positions, std::span<const Field> fields) {
    Hierarchy hierarchy{roots, {}, {}, {}};
    const std::size_t bisected_count = leaves.size() - roots.triangle_count();
    hierarchy.midpoints.reserve(bisected_count);
    hierarchy.bits.reserve((roots.triangle_count() + 2 * bisected_count + 63) / 64);
    write_preorder(hierarchy, leaves);

    std::vector<Index> old_numbers(roots.vertex_count());
    old_numbers.reserve(positions.size());
    std::iota(old_numbers.begin(), old_numbers.end(), Index{0});
    std::vector<Index> number(positions.size(), no_index);
    for (Index& midpoint : hierarchy.midpoints) {
        if (number[midpoint] == no_index) {
            number[midpoint] = static_cast<Index>(old_numbers.size());
            old_numbers.push_back(midpoint);
        }
        midpoint = number[midpoint];
    }
    hierarchy.positions.reserve(old_numbers.size());
    for (const Index old : old_numbers) hierarchy.positions.push_back(positions[old]);
    for (const Field& field : fields) hierarchy.fields.push_back(renumbered(field, old_numbers));
    return hierarchy;
}

std::vector<Leaf> leaves_of(const Hierarchy& hierarchy) {
    std::vector<Leaf> leaves;
    leaves.reserve(hierarchy.leaf_count());
    std::vector<Leaf> pending;
    std::size_t position = 0;
    auto midpoint = hierarchy.midpoints.begin();
    for (const Triangle& root : hierarchy.roots.triangles()) {
        pending.push_back({root, 0});
        while (!pending.empty()) {
            const Leaf node = pending.back();
            pending.pop_back();
            if (!hierarchy.is_bisected(position++)) {
                leaves.push_back(node);
                continue;
            }
            const auto [first, second] = bisect(node.vertices, *midpoint++);
            const auto level = static_cast<std::uint8_t>(node.level + 1);
            pending.push_back({second, level});
            pending.push_back({first, level});
        }
    }
    return leaves;
}

Hierarchy unrefined(const RootComplex& roots, const std::vector<glm::vec3>& positions) {
    Hierarchy hierarchy;
    hierarchy.bits.assign((roots.triangle_count() + 63) / 64, 0);
    hierarchy.positions.assign(positions.begin(), positions.end());
    hierarchy.roots = roots;
    return hierarchy;
}

}  // namespace interleaf
