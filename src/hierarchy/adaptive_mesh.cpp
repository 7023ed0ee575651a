#include "hierarchy/adaptive_mesh.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include <fmt/core.h>

#include "hierarchy/error.h"

namespace interleaf {

namespace {

// Sides of a triangle are numbered by the vertex they are opposite to. With bisect(), the two halves of the
// refinement edge lie on these sides of the children; the sibling is across the remaining one, and side 0 is
// inherited whole.
constexpr unsigned refinement_side = 0;
constexpr unsigned half_of_first = 2;
constexpr unsigned half_of_second = 1;

}  // namespace

AdaptiveMesh::AdaptiveMesh(RootComplex roots, std::vector<glm::vec3> positions, MidpointRule midpoint_rule)
    : roots_(std::move(roots)), positions_(std::move(positions)), midpoint_rule_(std::move(midpoint_rule)) {
    assert(positions_.size() == roots_.vertex_count());
    if (!midpoint_rule_)
        midpoint_rule_ = [this](Index a, Index b) { return (positions_[a] + positions_[b]) * 0.5F; };
    const Index count = roots_.triangle_count();
    leaves_.reserve(count);
    for (Index t = 0; t < count; ++t)
        leaves_.push_back(
            {roots_.triangles()[t], roots_.neighbours()[t], t + 1 < count ? t + 1 : no_index, 0, false, 0});
}

std::span<const Index> AdaptiveMesh::refine(std::span<const Index> marked) {
    // A leaf that closure has bisected meanwhile is done; its level tells.
    pending_.clear();
    for (const Index leaf : marked) pending_.push_back({leaf, leaves_[leaf].level});
    changed_.clear();
    for (const auto& [leaf, level] : pending_)
        if (leaves_[leaf].level == level) bisect_with_closure(leaf);
    return changed_;
}

Index AdaptiveMesh::leaves_added_by(Index leaf) {
    collect_chain(leaf);
    const bool ends_at_boundary = leaves_[chain_.back()].neighbours[refinement_side] == no_index;
    return static_cast<Index>(2 * chain_.size()) - (ends_at_boundary ? 1 : 0);
}

/// Fills chain_ with \p leaf and the leaves that must be bisected before it: each waits for the next, its
/// neighbour across its refinement edge, which has another refinement edge. The last is compatible, or waits
/// for an earlier one. \return the place in chain_ where such a cycle begins; the chain's size when there is
/// none
std::size_t AdaptiveMesh::collect_chain(Index leaf) {
    chain_.clear();
    std::size_t cycle_begin = 0;
    while (true) {
        chain_.push_back(leaf);
        leaves_[leaf].in_chain = true;
        if (is_compatible(leaf)) {
            cycle_begin = chain_.size();
            break;
        }
        leaf = leaves_[leaf].neighbours[refinement_side];
        if (leaves_[leaf].in_chain) {
            cycle_begin =
                static_cast<std::size_t>(std::find(chain_.begin(), chain_.end(), leaf) - chain_.begin());
            break;
        }
    }
    for (const Index waiting : chain_) leaves_[waiting].in_chain = false;
    return cycle_begin;
}

void AdaptiveMesh::bisect_with_closure(Index leaf) {
    const std::size_t cycle_begin = collect_chain(leaf);
    require_levels(cycle_begin);
    if (cycle_begin < chain_.size()) {
        bisect_cycle(std::span(chain_).subspan(cycle_begin));
        chain_.resize(cycle_begin);
    }
    for (; !chain_.empty(); chain_.pop_back()) bisect_pair(chain_.back());
}

/// Every leaf of the chain is bisected once, and once more where another leaf waits for it.
void AdaptiveMesh::require_levels(std::size_t cycle_begin) const {
    bool deep = false;
    for (std::size_t place = 0; place < chain_.size(); ++place) {
        const unsigned bisections = place > 0 || cycle_begin == 0 ? 2 : 1;
        deep = deep || leaves_[chain_[place]].level + bisections > max_level;
    }
    const Index partner = leaves_[chain_.back()].neighbours[refinement_side];
    deep = deep || (partner != no_index && leaves_[partner].level + 1U > max_level);
    if (deep)
        throw InputError(
            fmt::format("refinement would bisect a root triangle more than {} times", max_level));
}

bool AdaptiveMesh::is_compatible(Index leaf) const {
    const Index neighbour = leaves_[leaf].neighbours[refinement_side];
    return neighbour == no_index || leaves_[neighbour].neighbours[refinement_side] == leaf;
}

/// Bisects a compatible leaf and its neighbour, if any, across their common refinement edge.
void AdaptiveMesh::bisect_pair(Index leaf) {
    const Index partner = leaves_[leaf].neighbours[refinement_side];
    const Index midpoint = add_midpoint(leaf);
    const Index second = split(leaf, midpoint);
    if (partner == no_index) return;
    const Index partner_second = split(partner, midpoint);
    link(leaf, half_of_first, partner_second, half_of_second);
    link(second, half_of_second, partner, half_of_first);
}

/// Bisects leaves that wait for each other in a cycle as one step. Each has two edges bisected: its
/// refinement edge, shared with the next, and the entry edge, on which the one before waits and which is the
/// refinement edge of one of its children.
void AdaptiveMesh::bisect_cycle(std::span<const Index> cycle) {
    struct Member {
        Index leaf;
        Index midpoint;       ///< of the refinement edge
        unsigned entry_side;  ///< 1 or 2
        Index entry_child;    ///< the child that has the entry edge, then the first of its two children
        Index entry_second;   ///< the second of these
        Index half_first, half_second;     ///< the leaves with the halves of the refinement edge ...
        unsigned side_first, side_second;  ///< ... and on which sides of theirs
    };
    std::vector<Member> members(cycle.size());
    const auto before = [&](std::size_t m) { return (m + cycle.size() - 1) % cycle.size(); };
    for (std::size_t m = 0; m < cycle.size(); ++m) {
        members[m].leaf = cycle[m];
        members[m].midpoint = add_midpoint(cycle[m]);
        const Triangle& sides = leaves_[cycle[m]].neighbours;
        members[m].entry_side = sides[1] == cycle[before(m)] ? 1 : 2;
        assert(sides[members[m].entry_side] == cycle[before(m)]);
    }
    for (const Member& member : members)
        leaves_[member.leaf].neighbours[refinement_side] =
            leaves_[member.leaf].neighbours[member.entry_side] = no_index;

    for (std::size_t m = 0; m < cycle.size(); ++m) {
        Member& member = members[m];
        const Index second = split(member.leaf, member.midpoint);
        const bool entry_in_first = member.entry_side == 1;
        member.entry_child = entry_in_first ? member.leaf : second;
        member.entry_second = split(member.entry_child, members[before(m)].midpoint);
        // A half that lay in the child split just now is side 0 of one of its children: the second (p, l, k)
        // or the first (p, j, l).
        member.half_first = entry_in_first ? member.entry_second : member.leaf;
        member.side_first = entry_in_first ? refinement_side : half_of_first;
        member.half_second = second;
        member.side_second = entry_in_first ? half_of_second : refinement_side;
    }
    for (std::size_t m = 0; m < cycle.size(); ++m) {
        const Member& waits = members[before(m)];
        link(waits.half_first, waits.side_first, members[m].entry_second, half_of_second);
        link(waits.half_second, waits.side_second, members[m].entry_child, half_of_first);
    }
}

/// Bisects one triangle: the first child takes its place, the second is appended and returned. Links within
/// and across the inherited sides are made; the halves of the refinement edge are left unlinked.
Index AdaptiveMesh::split(Index leaf, Index midpoint) {
    const auto second_leaf = static_cast<Index>(leaves_.size());
    leaves_.push_back(leaves_[leaf]);
    LeafRecord& first = leaves_[leaf];
    LeafRecord& second = leaves_.back();

    const auto [across_jk, across_ki, across_ij] = first.neighbours;
    const auto children = bisect(first.vertices, midpoint);
    first.vertices = children[0];
    first.neighbours = {across_ki, second_leaf, no_index};
    second.vertices = children[1];
    second.neighbours = {across_ij, no_index, leaf};
    if (across_ij != no_index) redirect(across_ij, leaf, second_leaf);

    second.path |= std::uint64_t{1} << first.level;
    ++first.level;
    ++second.level;
    first.next = second_leaf;
    changed_.push_back(leaf);
    changed_.push_back(second_leaf);
    return second_leaf;
}

void AdaptiveMesh::link(Index a, unsigned side_a, Index b, unsigned side_b) {
    leaves_[a].neighbours[side_a] = b;
    leaves_[b].neighbours[side_b] = a;
}

/// The neighbour \p from of \p leaf has become \p to.
void AdaptiveMesh::redirect(Index leaf, Index from, Index to) {
    Triangle& sides = leaves_[leaf].neighbours;
    const auto side = std::find(sides.begin(), sides.end(), from);
    assert(side != sides.end());
    *side = to;
}

Index AdaptiveMesh::add_midpoint(Index leaf) {
    const Triangle& vertices = leaves_[leaf].vertices;
    const auto [a, b] = std::minmax(vertices[1], vertices[2]);
    positions_.push_back(midpoint_rule_(a, b));
    return static_cast<Index>(positions_.size() - 1);
}

std::vector<Index> AdaptiveMesh::preorder() const {
    std::vector<Index> order;
    order.reserve(leaves_.size());
    for (Index leaf = 0; leaf != no_index && order.size() < leaves_.size(); leaf = leaves_[leaf].next)
        order.push_back(leaf);
    return order;
}

Hierarchy AdaptiveMesh::freeze() const {
    std::vector<Leaf> leaves;
    leaves.reserve(leaves_.size());
    for (const Index leaf : preorder()) leaves.push_back({leaves_[leaf].vertices, leaves_[leaf].level});
    return hierarchy_from_leaves(roots_, leaves, positions_);
}

std::vector<std::string> AdaptiveMesh::violations() const {
    std::vector<std::string> found;
    if (const std::size_t listed = preorder().size(); listed != leaves_.size())
        found.push_back(fmt::format("{} leaves are in preorder, expected {}", listed, leaves_.size()));
    for (Index leaf = 0; leaf < leaves_.size(); ++leaf) {
        const LeafRecord& record = leaves_[leaf];
        if (record.in_chain) found.push_back(fmt::format("leaf {} is marked as waiting", leaf));
        if (record.level > max_level)
            found.push_back(fmt::format("leaf {} has level {}", leaf, record.level));
        for (unsigned side = 0; side < 3; ++side) {
            const Index neighbour = record.neighbours[side];
            if (neighbour == no_index) continue;
            const LeafRecord& other = leaves_[neighbour];
            const auto back =
                std::find(other.neighbours.begin(), other.neighbours.end(), leaf) - other.neighbours.begin();
            if (back == 3) {
                found.push_back(
                    fmt::format("leaf {} has the neighbour {}, which does not have it", leaf, neighbour));
                continue;
            }
            const auto corner = static_cast<std::size_t>(back);
            if (other.vertices[(corner + 1) % 3] != record.vertices[(side + 2) % 3] ||
                other.vertices[(corner + 2) % 3] != record.vertices[(side + 1) % 3])
                found.push_back(
                    fmt::format("leaf {} and its neighbour {} share no edge there", leaf, neighbour));
        }
    }
    return found;
}

}  // namespace interleaf
