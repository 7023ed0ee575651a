#include "hierarchy/literal.h"

#include <algorithm>
#include <functional>

namespace interleaf::testing {

namespace {

/// The midpoint of each triangle above the leaves.
std::map<Node, Index> midpoints_above(InfiniteComplex& complex, const std::set<Node>& leaves) {
    std::map<Node, Index> midpoints;
    for (Node node : leaves)
        while (node.level > 0) {
            node = node.parent();
            if (midpoints.contains(node)) break;
            const Triangle triangle = complex.triangle(node);
            midpoints[node] = complex.midpoint(triangle[1], triangle[2]);
        }
    return midpoints;
}

}  // namespace

Index InfiniteComplex::midpoint(Index a, Index b) {
    const auto [place, is_new] = midpoints_.try_emplace(std::minmax(a, b), next_);
    if (is_new) ++next_;
    return place->second;
}

Index InfiniteComplex::known_midpoint(Index a, Index b) const {
    const auto place = midpoints_.find(std::minmax(a, b));
    return place == midpoints_.end() ? no_index : place->second;
}

Triangle InfiniteComplex::triangle(const Node& node) {
    Triangle triangle = roots_->triangles()[node.root];
    for (unsigned level = 0; level < node.level; ++level)
        triangle = bisect(triangle, midpoint(triangle[1], triangle[2]))[node.path >> level & 1];
    return triangle;
}

std::set<Node> bisected_nodes(const Hierarchy& hierarchy) {
    std::set<Node> result;
    std::size_t position = 0;
    const std::function<void(const Node&)> visit = [&](const Node& node) {
        if (!hierarchy.is_bisected(position++)) return;
        result.insert(node);
        visit(node.child(0));
        visit(node.child(1));
    };
    for (std::size_t root = 0; root < hierarchy.roots.triangle_count(); ++root) visit({root, 0, 0});
    return result;
}

std::vector<Node> leaf_nodes(const std::set<Node>& bisected, std::size_t root_count) {
    std::vector<Node> leaves;
    const std::function<void(const Node&)> visit = [&](const Node& node) {
        if (!bisected.contains(node)) {
            leaves.push_back(node);
            return;
        }
        visit(node.child(0));
        visit(node.child(1));
    };
    for (std::size_t root = 0; root < root_count; ++root) visit({root, 0, 0});
    return leaves;
}

std::vector<Node> nodes_of_levels(const std::vector<unsigned>& levels) {
    std::vector<Node> leaves;
    Node next{0, 0, 0};
    for (const unsigned level : levels) {
        next.level = level;  // straight down the first children
        leaves.push_back(next);
        while (next.level > 0 && (next.path >> (next.level - 1) & 1) != 0) {
            next.path &= ~(std::uint64_t{1} << (next.level - 1));
            --next.level;
        }
        if (next.level == 0)
            next = {next.root + 1, 0, 0};
        else
            next.path |= std::uint64_t{1} << (next.level - 1);
    }
    return leaves;
}

std::set<Node> rivara(InfiniteComplex& complex, std::set<Node> leaves, const std::set<Node>& marked) {
    std::set<Node> selected = marked;
    while (!selected.empty()) {
        for (const Node& node : selected) {
            leaves.erase(node);
            leaves.insert(node.child(0));
            leaves.insert(node.child(1));
        }
        std::set<Index> vertices;
        for (const Node& leaf : leaves)
            for (const Index vertex : complex.triangle(leaf)) vertices.insert(vertex);
        selected.clear();
        for (const Node& leaf : leaves) {
            const auto [a, b, c] = complex.triangle(leaf);
            for (const auto& [from, to] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)})
                if (vertices.contains(complex.known_midpoint(from, to))) selected.insert(leaf);
        }
    }
    return leaves;
}

std::set<std::set<Index>> coarsening_steps(InfiniteComplex& complex, const std::set<Node>& leaves,
                                           const std::set<Node>& marked) {
    const std::map<Node, Index> midpoints = midpoints_above(complex, leaves);
    std::map<Index, std::set<Index>> needs;
    for (const auto& [node, midpoint] : midpoints) {
        needs[midpoint];
        if (node.level > 0) needs[midpoints.at(node.parent())].insert(midpoint);
    }
    std::set<Index> kept;  // vertices of leaves that are not marked
    for (const Node& leaf : leaves)
        if (!marked.contains(leaf))
            for (const Index vertex : complex.triangle(leaf)) kept.insert(vertex);

    const auto with_all_needed = [&](Index midpoint) {
        std::set<Index> all;
        const std::function<void(Index)> add = [&](Index added) {
            if (all.insert(added).second)
                for (const Index needed : needs.at(added)) add(needed);
        };
        add(midpoint);
        return all;
    };
    std::set<std::set<Index>> steps;
    for (const auto& entry : needs) {
        const Index midpoint = entry.first;
        const std::set<Index> together = with_all_needed(midpoint);
        const bool goes = std::all_of(together.begin(), together.end(), [&](Index other) {
            return !kept.contains(other) && with_all_needed(other).contains(midpoint);
        });
        if (goes) steps.insert(together);
    }
    return steps;
}

std::set<Node> coarsened(InfiniteComplex& complex, const std::set<Node>& leaves,
                         const std::set<std::set<Index>>& steps) {
    std::set<Index> removed;
    for (const std::set<Index>& step : steps) removed.insert(step.begin(), step.end());
    std::set<Node> bisected;
    for (const auto& [node, midpoint] : midpoints_above(complex, leaves))
        if (!removed.contains(midpoint)) bisected.insert(node);
    const std::vector<Node> result = leaf_nodes(bisected, complex.roots().triangle_count());
    return {result.begin(), result.end()};
}

std::vector<std::string> triangulation_violations(InfiniteComplex& complex, const std::vector<Node>& leaves,
                                                  unsigned level_difference) {
    std::map<std::pair<Index, Index>, unsigned>
        levels;  // of the triangle that traverses an edge in this direction
    std::vector<std::string> found;
    std::set<Index> vertices;
    for (const Node& leaf : leaves) {
        const Triangle triangle = complex.triangle(leaf);
        for (std::size_t k = 0; k < 3; ++k) {
            vertices.insert(triangle[k]);
            if (!levels.try_emplace({triangle[k], triangle[(k + 1) % 3]}, leaf.level).second)
                found.emplace_back("two triangles run along an edge in the same direction");
        }
    }

    std::set<std::pair<Index, Index>> boundary;
    const std::function<void(Index, Index)> add_boundary = [&](Index from, Index to) {
        const Index midpoint = complex.known_midpoint(from, to);
        if (midpoint == no_index || !vertices.contains(midpoint)) {
            boundary.insert({from, to});
            return;
        }
        add_boundary(from, midpoint);
        add_boundary(midpoint, to);
    };
    const RootComplex& roots = complex.roots();
    for (std::size_t t = 0; t < roots.triangle_count(); ++t)
        for (std::size_t k = 0; k < 3; ++k)
            if (roots.neighbors()[t][k] == no_index)
                add_boundary(roots.triangles()[t][(k + 1) % 3], roots.triangles()[t][(k + 2) % 3]);

    std::size_t edge_count = 0;
    for (const auto& [edge, level] : levels) {
        const auto opposite = levels.find({edge.second, edge.first});
        if (opposite == levels.end()) {
            ++edge_count;
            if (!boundary.contains(edge))
                found.emplace_back("an edge away from the boundary has one triangle");
            continue;
        }
        if (edge.first < edge.second) ++edge_count;
        if (boundary.contains(edge)) found.emplace_back("an edge on the boundary has two triangles");
        if (std::max(level, opposite->second) - std::min(level, opposite->second) > level_difference)
            found.emplace_back("neighbors differ by too many levels");
    }
    const auto euler =
        static_cast<int>(vertices.size()) - static_cast<int>(edge_count) + static_cast<int>(leaves.size());
    if (euler != roots.euler_number()) found.emplace_back("the Euler number is not that of the roots");
    return found;
}

}  // namespace interleaf::testing
