// Refinement of the adaptive mesh: Algorithm (A) (paper, section 2), leaf by leaf instead of in passes.
#include <algorithm>
#include <cassert>

#include <fmt/core.h>

#include "hierarchy/adaptive_mesh.h"
#include "hierarchy/error.h"

namespace interleaf {

// These are hints only: a leaf that was bisected before its turn does no harm. Always inlined, because g++ 12
// drops calls of a function that only prefetches.
[[gnu::always_inline]] inline void AdaptiveMesh::prefetch_to_bisect(std::size_t place) const {
    if (place + prefetch_leaf >= pending_.size()) return;
    __builtin_prefetch(&leaves_[pending_[place + prefetch_leaf].leaf]);
    if (const auto [leaf, level] = pending_[place + prefetch_neighbors]; leaves_[leaf].level == level) {
        const LeafRecord& record = leaves_[leaf];
        if (record.neighbors[0] != no_index) __builtin_prefetch(&leaves_[record.neighbors[0]]);
        if (record.neighbors[2] != no_index) __builtin_prefetch(&leaves_[record.neighbors[2]].neighbors);
        __builtin_prefetch(&positions_[record.vertices[1]]);
        __builtin_prefetch(&positions_[record.vertices[2]]);
    }
    if (const auto [leaf, level] = pending_[place + prefetch_beyond]; leaves_[leaf].level == level) {
        const Index partner = leaves_[leaf].neighbors[0];
        const Index beyond = partner == no_index ? no_index : leaves_[partner].neighbors[2];
        if (beyond != no_index) __builtin_prefetch(&leaves_[beyond].neighbors);
    }
}

void AdaptiveMesh::refine(std::span<const Index> marked, std::vector<Index>* changed) {
    // If closure has bisected a leaf in the meantime, its level shows that it is done.
    pending_.clear();
    for (const Index leaf : marked) pending_.push_back({leaf, leaves_[leaf].level});
    changed_ = changed;
    bool done = true;
    for (std::size_t place = 0; done && place < pending_.size(); ++place) {
        prefetch_to_bisect(place);
        const auto [leaf, level] = pending_[place];
        if (leaves_[leaf].level == level) done = bisect_with_closure(leaf);
    }
    place_new_vertices();
    if (!done)
        throw InputError(
            fmt::format("refinement would bisect a root triangle more than {} times", max_level));
}

Index AdaptiveMesh::leaves_added_by(Index leaf) {
    collect_chain(leaf);
    const bool ends_at_boundary = leaves_[chain_.back()].neighbors[refinement_side] == no_index;
    return static_cast<Index>(2 * chain_.size()) - (ends_at_boundary ? 1 : 0);
}

/// Fills chain_ with \p leaf and the leaves that must be bisected before it. Each waits for the next one: its
/// neighbor across its refinement edge, which has a different refinement edge. The last leaf is compatible,
/// or waits for an earlier one.
/// \return the place in chain_ where such a cycle begins; the chain's size if there is none
std::size_t AdaptiveMesh::collect_chain(Index leaf) {
    chain_.clear();
    std::size_t cycle_begin = 0;
    while (true) {
        chain_.push_back(leaf);
        leaves_[leaf].is_flagged = true;
        if (is_compatible(leaf)) {
            cycle_begin = chain_.size();
            break;
        }
        leaf = leaves_[leaf].neighbors[refinement_side];
        if (leaves_[leaf].is_flagged) {
            cycle_begin =
                static_cast<std::size_t>(std::find(chain_.begin(), chain_.end(), leaf) - chain_.begin());
            break;
        }
    }
    for (const Index waiting : chain_) leaves_[waiting].is_flagged = false;
    return cycle_begin;
}

/// \return false, with nothing changed, if a leaf would become too deep
bool AdaptiveMesh::bisect_with_closure(Index leaf) {
    if (is_compatible(leaf) && leaves_[leaf].level < max_level - 1) {  // most are
        bisect_pair(leaf);
        return true;
    }
    const std::size_t cycle_begin = collect_chain(leaf);
    if (!has_levels_left(cycle_begin)) return false;
    if (cycle_begin < chain_.size()) {
        bisect_cycle(std::span(chain_).subspan(cycle_begin));
        chain_.resize(cycle_begin);
    }
    for (; !chain_.empty(); chain_.pop_back()) bisect_pair(chain_.back());
    return true;
}

/// Every leaf of the chain is bisected once, and once more if another leaf waits for it.
bool AdaptiveMesh::has_levels_left(std::size_t cycle_begin) const {
    for (std::size_t place = 0; place < chain_.size(); ++place) {
        const unsigned bisections = place > 0 || cycle_begin == 0 ? 2 : 1;
        if (leaves_[chain_[place]].level + bisections > max_level) return false;
    }
    const Index partner = leaves_[chain_.back()].neighbors[refinement_side];
    return partner == no_index || leaves_[partner].level + 1U <= max_level;
}

/// Bisects a compatible leaf, and its neighbor if there is one, at their common refinement edge.
void AdaptiveMesh::bisect_pair(Index leaf) {
    const Index partner = leaves_[leaf].neighbors[refinement_side];
    const Index midpoint = add_midpoint(leaf);
    const Index second = free_place();
    if (partner == no_index) return split(leaf, second, midpoint, {no_index, no_index});
    const Index partner_second = free_place();
    split(leaf, second, midpoint, {partner_second, partner});
    split(partner, partner_second, midpoint, {second, leaf});
}

/// Bisects leaves that wait for each other in a cycle, as one step. Two edges of each are bisected: its
/// refinement edge, which it shares with the next leaf, and its entry edge, where the previous leaf waits.
/// The entry edge is the refinement edge of one of the leaf's children.
void AdaptiveMesh::bisect_cycle(std::span<const Index> cycle) {
    struct Member {
        Index leaf;
        Index midpoint;       ///< of the refinement edge
        unsigned entry_side;  ///< 1 or 2
        /// First the child that has the entry edge, then the first of that child's two children.
        Index entry_child;
        Index entry_second;                ///< the second of that child's two children
        Index half_first, half_second;     ///< the leaves with the halves of the refinement edge ...
        unsigned side_first, side_second;  ///< ... and the sides of these leaves where the halves lie
    };
    std::vector<Member> members(cycle.size());
    const auto before = [&](std::size_t m) { return (m + cycle.size() - 1) % cycle.size(); };
    for (std::size_t m = 0; m < cycle.size(); ++m) {
        members[m].leaf = cycle[m];
        members[m].midpoint = add_midpoint(cycle[m]);
        const Triangle& sides = leaves_[cycle[m]].neighbors;
        members[m].entry_side = sides[1] == cycle[before(m)] ? 1 : 2;
        assert(sides[members[m].entry_side] == cycle[before(m)]);
    }
    for (const Member& member : members)
        leaves_[member.leaf].neighbors[refinement_side] = leaves_[member.leaf].neighbors[member.entry_side] =
            no_index;

    for (std::size_t m = 0; m < cycle.size(); ++m) {
        Member& member = members[m];
        const Index second = free_place();
        split(member.leaf, second, member.midpoint, {no_index, no_index});
        const bool entry_in_first = member.entry_side == 1;
        member.entry_child = entry_in_first ? member.leaf : second;
        member.entry_second = free_place();
        split(member.entry_child, member.entry_second, members[before(m)].midpoint, {no_index, no_index});
        // If a half lay in the child that was just split, it is now side 0 of one of its children: of the
        // second (p, l, k) or of the first (p, j, l).
        member.half_first = entry_in_first ? member.entry_second : member.leaf;
        member.side_first = entry_in_first ? refinement_side : half_side[0];
        member.half_second = second;
        member.side_second = entry_in_first ? half_side[1] : refinement_side;
    }
    for (std::size_t m = 0; m < cycle.size(); ++m) {
        const Member& waits = members[before(m)];
        link(waits.half_first, waits.side_first, members[m].entry_second, half_side[1]);
        link(waits.half_second, waits.side_second, members[m].entry_child, half_side[0]);
    }
}

/// Bisects one triangle. The first child takes its place, the second the place \p second.
/// \param across_halves  the neighbors of the first and of the second child across their halves of the
///     refinement edge
void AdaptiveMesh::split(Index leaf, Index second, Index midpoint, std::array<Index, 2> across_halves) {
    const LeafRecord parent = leaves_[leaf];
    const auto [across_jk, across_ki, across_ij] = parent.neighbors;
    const auto children = bisect(parent.vertices, midpoint);
    const auto level = static_cast<std::uint8_t>(parent.level + 1);
    leaves_[leaf] = {children[0], {across_ki, second, across_halves[0]}, second, level, false, parent.path};
    leaves_[second] = {children[1], {across_ij, across_halves[1], leaf},           parent.next, level,
                       false,       parent.path | std::uint64_t{1} << parent.level};
    if (across_ij != no_index) redirect(across_ij, leaf, second);
    report_changed(leaf);
    report_changed(second);
}

Index AdaptiveMesh::add_midpoint(Index leaf) {
    constexpr std::size_t batch = 256;
    const Triangle& vertices = leaves_[leaf].vertices;
    const auto [a, b] = std::minmax(vertices[1], vertices[2]);
    Index midpoint;
    if (free_vertices_.empty()) {
        midpoint = static_cast<Index>(positions_.append());
    } else {
        midpoint = free_vertices_.back();
        free_vertices_.pop_back();
    }
    new_vertices_.push_back({a, b, midpoint});
    if (new_vertices_.size() == batch) place_new_vertices();
    return midpoint;
}

void AdaptiveMesh::place_new_vertices() {
    place_vertices_(new_vertices_);
    new_vertices_.clear();
}

}  // namespace interleaf
