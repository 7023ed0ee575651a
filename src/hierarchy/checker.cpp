#include "hierarchy/checker.h"

#include <array>
#include <cmath>
#include <utility>

#include <fmt/core.h>

namespace interleaf {

namespace {

/// Violations up to a limit.
class Report {
  public:
    explicit Report(std::size_t limit) : limit_(limit) {}

    template <typename... Arguments>
    void add(fmt::format_string<Arguments...> format, Arguments&&... arguments) {
        if (full()) return;
        violations_.push_back(fmt::format(format, std::forward<Arguments>(arguments)...));
        if (full()) violations_.back() += " (the check ends here)";
    }

    bool full() const { return violations_.size() >= limit_; }
    bool empty() const { return violations_.empty(); }
    std::vector<std::string> take() { return std::move(violations_); }

  private:
    std::size_t limit_;
    std::vector<std::string> violations_;
};

/// Whether the arrays have the sizes that the counts ask for, so that the walk may read them.
bool check_sizes(const Hierarchy& hierarchy, Report& report) {
    if (hierarchy.roots.triangle_count() == 0) report.add("there are no root triangles");
    const std::size_t words = (hierarchy.node_count() + 63) / 64;
    if (hierarchy.bits.size() != words)
        report.add("there are {} words of preorder bits, expected {} for {} nodes", hierarchy.bits.size(),
                   words, hierarchy.node_count());
    if (hierarchy.positions.size() < hierarchy.roots.vertex_count())
        report.add("there are {} vertices, expected at least the {} root vertices",
                   hierarchy.positions.size(), hierarchy.roots.vertex_count());
    if (hierarchy.positions.size() >= no_index)
        report.add("there are {} vertices, too many", hierarchy.positions.size());
    return report.empty();
}

void check_positions(const Hierarchy& hierarchy, Report& report) {
    for (std::size_t v = 0; v < hierarchy.positions.size() && !report.full(); ++v) {
        const glm::vec3& p = hierarchy.positions[v];
        if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z))
            report.add("vertex {} is at ({}, {}, {}), expected finite coordinates", v, p.x, p.y, p.z);
    }
}

/// The walk over the preorder that checks trees, numbering and conformity at once.
class Walk {
  public:
    Walk(const Hierarchy& hierarchy, Report& report)
        : hierarchy_(hierarchy), report_(report), edges_(hierarchy.positions.size(), closed) {}

    void run() {
        const auto roots = hierarchy_.roots.triangles();
        next_vertex_ = hierarchy_.roots.vertex_count();
        for (root_ = 0; root_ < roots.size(); ++root_)
            if (!walk_root(roots[root_])) return;
        check_leftovers();
    }

  private:
    using Edge = std::array<Index, 2>;
    static constexpr Edge closed = {no_index, no_index};

    struct Node {
        Triangle vertices;
        unsigned level;
        unsigned boundary;  ///< bit c: the edge opposite vertex c is on the boundary of the surface
    };

    /// \return false when what follows cannot be read
    bool walk_root(const Triangle& root) {
        const Triangle& sides = hierarchy_.roots.neighbours()[root_];
        unsigned boundary = 0;
        for (unsigned c = 0; c < 3; ++c) boundary |= static_cast<unsigned>(sides[c] == no_index) << c;
        pending_.assign(1, {root, 0, boundary});
        while (!pending_.empty()) {
            const Node node = pending_.back();
            pending_.pop_back();
            if (position_ == hierarchy_.node_count()) {
                report_.add("root {}: the preorder ends before its tree is complete", root_);
                return false;
            }
            if (hierarchy_.is_bisected(position_) && !bisect_node(node)) return false;
            ++position_;
        }
        return true;
    }

    bool bisect_node(const Node& node) {
        if (node.level == max_level) {
            report_.add("root {}, node {}: bisected at level {}, expected leaves at most {} levels deep",
                        root_, position_, node.level, max_level);
            return false;
        }
        if (next_midpoint_ == hierarchy_.midpoints.size()) {
            report_.add("root {}, node {}: bisected, but all {} midpoints are used up", root_, position_,
                        hierarchy_.midpoints.size());
            return false;
        }
        const Index midpoint = hierarchy_.midpoints[next_midpoint_++];
        const auto [i, j, k] = node.vertices;
        if (!visit_midpoint(midpoint, {j, k}, (node.boundary & 1) != 0)) return false;
        // Edges of the children (l, k, i) and (l, i, j), opposite their vertices: (ki, il, lk) and (ij, jl,
        // li).
        const unsigned jk = node.boundary & 1;
        const unsigned ki = node.boundary >> 1 & 1;
        const unsigned ij = node.boundary >> 2 & 1;
        const auto [first, second] = bisect(node.vertices, midpoint);
        pending_.push_back({second, node.level + 1, ij | jk << 1});
        pending_.push_back({first, node.level + 1, ki | jk << 2});
        return true;
    }

    bool visit_midpoint(Index midpoint, const Edge& edge, bool on_boundary) {
        if (midpoint < hierarchy_.roots.vertex_count() || midpoint > next_vertex_ ||
            midpoint >= hierarchy_.positions.size()) {
            report_.add(
                "root {}, node {}: the midpoint is vertex {}, expected {} (the next new one) or a midpoint "
                "visited before",
                root_, position_, midpoint, next_vertex_);
            return false;
        }
        if (midpoint == next_vertex_) {
            ++next_vertex_;
            if (on_boundary) return true;
            edges_[midpoint] = edge;
            ++open_count_;
            return true;
        }
        if (edges_[midpoint] == Edge{edge[1], edge[0]}) {
            edges_[midpoint] = closed;
            --open_count_;
            return true;
        }
        if (edges_[midpoint] == closed)
            report_.add(
                "root {}, node {}: vertex {} bisects edge ({}, {}), but was already the midpoint of another "
                "edge",
                root_, position_, midpoint, edge[0], edge[1]);
        else
            report_.add(
                "root {}, node {}: vertex {} bisects edge ({}, {}), expected ({}, {}), the other side of its "
                "first visit",
                root_, position_, midpoint, edge[0], edge[1], edges_[midpoint][1], edges_[midpoint][0]);
        return !report_.full();
    }

    void check_leftovers() {
        if (position_ != hierarchy_.node_count())
            report_.add("{} nodes follow the last root's tree", hierarchy_.node_count() - position_);
        const std::size_t used = hierarchy_.node_count() % 64;
        if (used != 0 && hierarchy_.bits.back() >> used != 0)
            report_.add("bits after the last node are set, expected 0");
        if (next_midpoint_ != hierarchy_.midpoints.size())
            report_.add("{} midpoints are left over", hierarchy_.midpoints.size() - next_midpoint_);
        if (next_vertex_ != hierarchy_.positions.size())
            report_.add("vertex {} is no midpoint; {} vertices are used by no node", next_vertex_,
                        hierarchy_.positions.size() - next_vertex_);
        if (open_count_ == 0) return;
        for (std::size_t v = 0; v < edges_.size() && !report_.full(); ++v)
            if (edges_[v] != closed)
                report_.add("vertex {} bisects edge ({}, {}) on one side only: it hangs on the other", v,
                            edges_[v][0], edges_[v][1]);
    }

    const Hierarchy& hierarchy_;
    Report& report_;
    std::vector<Edge>
        edges_;  ///< of each vertex: the edge it was first visited on while its other side is awaited
    std::vector<Node> pending_;
    std::size_t root_ = 0;
    std::size_t position_ = 0;
    std::size_t next_midpoint_ = 0;
    Index next_vertex_ = 0;
    std::size_t open_count_ = 0;
};

}  // namespace

std::vector<std::string> check(const Hierarchy& hierarchy, std::size_t limit) {
    Report report(limit);
    if (check_sizes(hierarchy, report)) {
        Walk(hierarchy, report).run();
        check_positions(hierarchy, report);
    }
    return report.take();
}

std::string difference(const RootComplex& first, const RootComplex& other) {
    if (other.vertex_count() != first.vertex_count() || other.triangle_count() != first.triangle_count())
        return fmt::format("{} root triangles over {} vertices, expected {} over {}", other.triangle_count(),
                           other.vertex_count(), first.triangle_count(), first.vertex_count());
    for (Index t = 0; t < first.triangle_count(); ++t) {
        const auto& [a, b, c] = first.triangles()[t];
        const auto& [d, e, f] = other.triangles()[t];
        if (first.triangles()[t] != other.triangles()[t])
            return fmt::format("root triangle {} is ({}, {}, {}), expected ({}, {}, {})", t, d, e, f, a, b,
                               c);
    }
    return {};
}

std::vector<std::string> check_constraints(std::span<const Hierarchy* const> keys) {
    std::vector<std::string> violations;
    for (std::size_t key = 1; key < keys.size(); ++key) {
        const std::string found = difference(keys[0]->roots, keys[key]->roots);
        if (!found.empty())
            violations.push_back(fmt::format("key {} has other roots than key 0: {}", key, found));
    }
    return violations;
}

}  // namespace interleaf
