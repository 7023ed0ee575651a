// Coarsening of the adaptive mesh: the inverse of refinement.
//
// The bisection of a pair makes a midpoint with the four children of the pair around it, or two children at
// the boundary. As long as none of these is bisected, they are the leaves around the midpoint, and it is
// their newest vertex. If a cycle was bisected as one step, three leaves of each of its triangles remain: one
// whole child, and the two children of the other child, which is split at the edge where the previous
// triangle of the cycle waited.
#include <algorithm>
#include <cassert>

#include "hierarchy/adaptive_mesh.h"

namespace interleaf {

// See prefetch_to_bisect().
[[gnu::always_inline]] inline void AdaptiveMesh::prefetch_to_merge(std::size_t place) const {
    if (place + prefetch_leaf >= pending_.size()) return;
    __builtin_prefetch(&leaves_[pending_[place + prefetch_leaf].leaf]);
    const auto ask_for = [&](Index leaf) {
        if (leaf != no_index) __builtin_prefetch(&leaves_[leaf].neighbors);
    };
    const LeafRecord& later = leaves_[pending_[place + prefetch_neighbors].leaf];
    if (later.is_flagged)
        for (const Index neighbor : later.neighbors) ask_for(neighbor);
    const LeafRecord& next = leaves_[pending_[place + prefetch_beyond].leaf];
    if (next.is_flagged)
        for (const unsigned side : {1U, 2U})
            if (next.neighbors[side] != no_index) {
                ask_for(leaves_[next.neighbors[side]].neighbors[0]);
                ask_for(leaves_[next.neighbors[side]].neighbors[side]);
            }
}

void AdaptiveMesh::coarsen(std::span<const Index> marked, std::vector<Index>* changed) {
    pending_.clear();
    for (const Index leaf : marked) {
        assert(is_leaf(leaf));
        pending_.push_back({leaf, 0});
        leaves_[leaf].is_flagged = true;
    }
    changed_ = changed;
    for (std::size_t place = 0; place < pending_.size(); ++place) {
        prefetch_to_merge(place);
        const Index leaf = pending_[place].leaf;
        if (!leaves_[leaf].is_flagged) continue;
        // A midpoint that cannot be removed now cannot be removed later in this call: a triangle that becomes
        // a leaf is not flagged.
        if (!coarsen_pair(leaf) && !coarsen_cycle(leaf)) leaves_[leaf].is_flagged = false;
    }
}

/// \p leaf and its sibling; none if the sibling is not a leaf.
std::optional<AdaptiveMesh::Siblings> AdaptiveMesh::siblings(Index leaf) const {
    const LeafRecord& record = leaves_[leaf];
    if (record.level == 0) return std::nullopt;
    const bool second = is_second(leaf);
    const Index sibling = record.neighbors[sibling_side[second]];
    if (leaves_[sibling].level != record.level) return std::nullopt;
    return second ? Siblings{sibling, leaf} : Siblings{leaf, sibling};
}

bool AdaptiveMesh::is_flagged(const Siblings& pair) const {
    return leaves_[pair.first].is_flagged && leaves_[pair.second].is_flagged;
}

/// Removes the newest vertex of \p leaf if only flagged children of one pair are around it.
bool AdaptiveMesh::coarsen_pair(Index leaf) {
    const std::optional<Siblings> pair = siblings(leaf);
    if (!pair || !is_flagged(*pair)) return false;
    const Index midpoint = leaves_[leaf].vertices[0];
    const Siblings partners = {leaves_[pair->second].neighbors[half_side[1]],
                               leaves_[pair->first].neighbors[half_side[0]]};
    const bool at_boundary = partners.first == no_index;
    // A vertex is the newest vertex of the children of the triangles that were bisected there, and of no
    // other leaf.
    if (!at_boundary && !(leaves_[partners.first].vertices[0] == midpoint &&
                          leaves_[partners.second].vertices[0] == midpoint && is_flagged(partners)))
        return false;

    const Index parent = merge(*pair);
    report_changed(parent);
    if (!at_boundary) {
        const Index partner = merge(partners);
        report_changed(partner);
        link(parent, refinement_side, partner, refinement_side);
    }
    free_vertices_.push_back(midpoint);
    return true;
}

/// The triangle of a cycle whose leaf child is \p whole; none if there is no such triangle.
std::optional<AdaptiveMesh::CycleMember> AdaptiveMesh::cycle_member(Index whole) const {
    const LeafRecord& record = leaves_[whole];
    if (record.level == 0) return std::nullopt;
    const bool second = is_second(whole);
    const Index beside = record.neighbors[sibling_side[second]];
    if (leaves_[beside].level != record.level + 1) return std::nullopt;
    const std::optional<Siblings> split = siblings(beside);
    if (!split) return std::nullopt;
    return CycleMember{whole, second, *split};
}

/// Looks across the entry edge, which \p split bisects. The result is the leaf that is a whole child of the
/// triangle there, or no_index if that triangle does not have exactly one.
Index AdaptiveMesh::whole_across(const Siblings& split) const {
    const Index midpoint = leaves_[split.first].vertices[0];
    const Index one = leaves_[split.first].neighbors[half_side[0]];
    const Index other = leaves_[split.second].neighbors[half_side[1]];
    if (one == no_index) return no_index;
    const bool one_is = leaves_[one].vertices[0] == midpoint;
    const bool other_is = leaves_[other].vertices[0] == midpoint;
    return one_is == other_is ? no_index : one_is ? one : other;
}

/// Fills cycle_ with the triangles that were bisected in one step around \p leaf, each followed by the
/// triangle it waited for, if their children are flagged. No two triangles precede the same triangle, so the
/// sequence ends or closes.
bool AdaptiveMesh::collect_cycle(Index leaf) {
    cycle_.clear();
    const std::optional<Siblings> pair = siblings(leaf);
    const Index start = pair ? whole_across(*pair) : leaf;
    Index whole = start;
    do {
        if (whole == no_index) return false;
        const std::optional<CycleMember> member = cycle_member(whole);
        if (!member || !leaves_[whole].is_flagged || !is_flagged(member->split)) return false;
        cycle_.push_back(*member);
        whole = whole_across(member->split);
    } while (whole != start);
    return true;
}

/// Removes the midpoints of a cycle as one step: the inverse of bisect_cycle().
bool AdaptiveMesh::coarsen_cycle(Index leaf) {
    if (!collect_cycle(leaf)) return false;
    for (const auto& [whole, is_second, split] : cycle_) {
        // The halves of the refinement edge and of the entry edge lose their links: the triangles across
        // these edges change, too.
        leaves_[whole].neighbors[half_side[is_second]] = no_index;
        leaves_[is_second ? split.second : split.first].neighbors[0] = no_index;
        leaves_[split.first].neighbors[half_side[0]] = no_index;
        leaves_[split.second].neighbors[half_side[1]] = no_index;
        free_vertices_.push_back(leaves_[whole].vertices[0]);
    }
    for (CycleMember& member : cycle_) {
        const Index entered = merge(member.split);
        member.whole =
            merge(member.is_second ? Siblings{entered, member.whole} : Siblings{member.whole, entered});
        report_changed(member.whole);
    }
    for (std::size_t m = 0; m < cycle_.size(); ++m) {
        const unsigned entry_side = cycle_[m].is_second ? 1 : 2;
        link(cycle_[m].whole, entry_side, cycle_[(m + 1) % cycle_.size()].whole, refinement_side);
    }
    return true;
}

/// Puts the parent of two leaves in the place of the first and frees the place of the second. The two sides
/// that the leaves inherited whole keep their links; the parent's refinement edge is left unlinked.
Index AdaptiveMesh::merge(const Siblings& pair) {
    LeafRecord& first = leaves_[pair.first];
    LeafRecord& second = leaves_[pair.second];
    const Index across_ij = second.neighbors[0];
    if (across_ij != no_index) redirect(across_ij, pair.second, pair.first);
    first.neighbors = {no_index, first.neighbors[0], across_ij};
    first.vertices = interleaf::merge(first.vertices, second.vertices);
    first.next = second.next;
    --first.level;  // the path has no bit set for a first child
    first.is_flagged = second.is_flagged = false;
    second.level = no_level;
    free_leaves_.push_back(pair.second);
    return pair.first;
}

}  // namespace interleaf
