#include "hierarchy/checker.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <utility>

#include <fmt/core.h>

namespace interleaf {

namespace {

/// Collects violations up to a limit.
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

/// Whether the arrays have the sizes that the counts imply, so that the walk may read them.
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

/// Whether all floats are finite: no exponent has all bits set.
bool are_finite(std::span<const float> values) {
    constexpr std::uint32_t exponent = 0x7f800000;
    std::uint32_t found = 0;
    for (const float value : values) found |= (std::bit_cast<std::uint32_t>(value) & exponent) == exponent;
    return found == 0;
}

void check_positions(const Hierarchy& hierarchy, Report& report) {
    static_assert(sizeof(glm::vec3) == 3 * sizeof(float));
    if (are_finite({&hierarchy.positions.data()->x, 3 * hierarchy.positions.size()})) return;
    for (std::size_t v = 0; v < hierarchy.positions.size() && !report.full(); ++v) {
        const glm::vec3& p = hierarchy.positions[v];
        if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z))
            report.add("vertex {} is at ({}, {}, {}), expected finite coordinates", v, p.x, p.y, p.z);
    }
}

/// Whether \p value is allowed in a field of kind \p kind.
bool is_allowed(float value, FieldKind kind) {
    return kind == FieldKind::color ? value >= 0 && value <= 1 : std::isfinite(value);
}

void check_values(const Field& field, std::size_t vertex_count, Report& report) {
    const std::size_t width = component_count(field.kind);
    if (field.kind != FieldKind::scalar && field.kind != FieldKind::color)
        return report.add("field \"{}\" is of kind {}, expected 1 or 3", field.name, width);
    if (field.values.size() != width * vertex_count)
        return report.add("field \"{}\" has {} values, expected {} for {} vertices", field.name,
                          field.values.size(), width * vertex_count, vertex_count);
    if (field.kind == FieldKind::scalar && are_finite(field.values)) return;
    for (std::size_t n = 0; n < field.values.size() && !report.full(); ++n)
        if (!is_allowed(field.values[n], field.kind))
            report.add("field \"{}\" is {} at vertex {}, expected {}", field.name, field.values[n], n / width,
                       field.kind == FieldKind::color ? "color components from 0 to 1" : "finite values");
}

void check_fields(const Hierarchy& hierarchy, Report& report) {
    const std::vector<Field>& fields = hierarchy.fields;
    if (fields.size() > max_field_count)
        return report.add("there are {} fields, expected at most {}", fields.size(), max_field_count);
    for (std::size_t f = 0; f < fields.size() && !report.full(); ++f) {
        const auto has_name = [&](const Field& other) { return other.name == fields[f].name; };
        if (!is_field_name(fields[f].name))
            report.add("the name of field {} is not 1 to {} bytes of UTF-8 without control characters", f,
                       max_field_name);
        else if (std::any_of(fields.data(), fields.data() + f, has_name))
            report.add("two fields are called \"{}\"", fields[f].name);
        else
            check_values(fields[f], hierarchy.positions.size(), report);
    }
}

/// An edge from one vertex to another, packed into one number.
constexpr std::uint64_t directed(Index from, Index to) {
    return from | std::uint64_t{to} << 32;
}
constexpr Index from_of(std::uint64_t edge) {
    return static_cast<Index>(edge);
}
constexpr Index to_of(std::uint64_t edge) {
    return static_cast<Index>(edge >> 32);
}

/// A node on the stack, packed into two words. The walk writes a node and reads it back soon after. A read
/// that is wider than the preceding writes would stall until they reach the cache, so both use whole words.
struct PendingNode {
    std::uint64_t i_and_j;
    std::uint64_t k_and_place;

    PendingNode() = default;
    /// \param boundary  bit c is set if the edge opposite vertex c is on the boundary of the surface
    PendingNode(Index i, Index j, Index k, unsigned level, unsigned boundary)
        : i_and_j(directed(i, j)), k_and_place(directed(k, level << 3 | boundary)) {}

    Index i() const { return from_of(i_and_j); }
    Index j() const { return to_of(i_and_j); }
    Index k() const { return from_of(k_and_place); }
    unsigned level() const { return to_of(k_and_place) >> 3; }
    unsigned boundary() const { return to_of(k_and_place) & 7; }
};

/// The walk over the preorder, which checks trees, numbering and conformity at once.
///
/// It runs whenever a file is read, so it has no branch that depends on the forest: it passes over leaves in
/// runs, and distinguishes a midpoint's first and second visit by arithmetic. Branches that are taken only on
/// a violation cost nothing.
class Walk {
  public:
    Walk(const Hierarchy& hierarchy, Report& report)
        : hierarchy_(hierarchy), report_(report), progress_{0, 0, hierarchy.roots.vertex_count(), 0} {
        edges_.resize(hierarchy.positions.size());
    }

    void run() {
        const auto roots = hierarchy_.roots.triangles();
        for (root_ = 0; root_ < roots.size(); ++root_) {
            Progress progress = progress_;  // a local copy, so that the loop keeps it in registers
            const bool readable = walk_tree(roots[root_], progress);
            progress_ = progress;
            if (!readable) return;
        }
        check_leftovers();
    }

  private:
    static constexpr std::uint64_t closed = directed(no_index, no_index);

    struct Progress {
        std::size_t position;  ///< of the next node in the preorder
        std::size_t midpoint;  ///< place of the next midpoint
        Index next_vertex;     ///< the vertex that the next first visit must meet
        std::size_t open;      ///< midpoints still waiting for the visit from their other side
    };

    /// \return false if the rest cannot be read
    bool walk_tree(const Triangle& root, Progress& progress) {
        const std::size_t node_count = hierarchy_.node_count();
        std::size_t pending = 0;
        stack_[pending++] = PendingNode(root[0], root[1], root[2], 0, boundary_of_root());
        while (true) {
            const std::size_t rest = std::min(64 - progress.position % 64, node_count - progress.position);
            if (rest == 0) return report_end();
            const std::uint64_t word = hierarchy_.bits[progress.position / 64] >> (progress.position % 64);
            const auto leaves = static_cast<std::size_t>(std::countr_zero(word));
            const std::size_t run = std::min({leaves, rest, pending});
            progress.position += run;
            pending -= run;
            if (pending == 0) return true;
            if (run == rest) continue;  // the next word, or the end

            const PendingNode node = stack_[--pending];
            if (node.level() == max_level) return report_depth(progress.position);
            if (progress.midpoint == hierarchy_.midpoints.size())
                return report_no_midpoint(progress.position);
            const Index midpoint = hierarchy_.midpoints[progress.midpoint++];
            if (midpoint < hierarchy_.roots.vertex_count() || midpoint > progress.next_vertex ||
                midpoint >= edges_.size())
                return report_number(progress.position, midpoint, progress.next_vertex);

            const std::uint64_t edge = directed(node.j(), node.k());
            const std::uint64_t other_side = directed(node.k(), node.j());
            const bool is_new = midpoint == progress.next_vertex;
            const bool is_inner = (node.boundary() & 1) == 0;
            const std::uint64_t awaited = is_new ? other_side : edges_[midpoint];
            if (awaited != other_side && !report_wrong_edge(progress.position, midpoint, edge)) return false;
            edges_[midpoint] = is_new && is_inner ? edge : closed;
            progress.next_vertex += is_new;
            progress.open += is_new ? is_inner : std::size_t{0} - 1;

            // Edges of the children (l, k, i) and (l, i, j), opposite their vertices: (ki, il, lk) and (ij,
            // jl, li).
            const unsigned jk = node.boundary() & 1, ki = node.boundary() >> 1 & 1, ij = node.boundary() >> 2;
            put(pending++, PendingNode(midpoint, node.i(), node.j(), node.level() + 1, ij | jk << 1));
            put(pending++, PendingNode(midpoint, node.k(), node.i(), node.level() + 1, ki | jk << 2));
            ++progress.position;
        }
    }

    unsigned boundary_of_root() const {
        const Triangle& sides = hierarchy_.roots.neighbors()[root_];
        unsigned boundary = 0;
        for (unsigned c = 0; c < 3; ++c) boundary |= static_cast<unsigned>(sides[c] == no_index) << c;
        return boundary;
    }

    /// Writes word by word, because the stack is read in the same widths.
    void put(std::size_t place, const PendingNode& node) {
        stack_[place].i_and_j = node.i_and_j;
        stack_[place].k_and_place = node.k_and_place;
    }

    // Each returns whether the rest can be read. They take copies: see run().

    bool report_end() {
        report_.add("root {}: the preorder ends before its tree is complete", root_);
        return false;
    }
    bool report_depth(std::size_t position) {
        report_.add("root {}, node {}: bisected at level {}, expected leaves at most {} levels deep", root_,
                    position, max_level, max_level);
        return false;
    }
    bool report_no_midpoint(std::size_t position) {
        report_.add("root {}, node {}: bisected, but all {} midpoints are used up", root_, position,
                    hierarchy_.midpoints.size());
        return false;
    }
    bool report_number(std::size_t position, Index midpoint, Index next_vertex) {
        report_.add(
            "root {}, node {}: the midpoint is vertex {}, expected {} (the next new one) or a midpoint "
            "visited before",
            root_, position, midpoint, next_vertex);
        return false;
    }
    bool report_wrong_edge(std::size_t position, Index midpoint, std::uint64_t edge) {
        const std::uint64_t awaited = edges_[midpoint];
        if (awaited == closed)
            report_.add(
                "root {}, node {}: vertex {} bisects edge ({}, {}), but was already the midpoint of another "
                "edge",
                root_, position, midpoint, from_of(edge), to_of(edge));
        else
            report_.add(
                "root {}, node {}: vertex {} bisects edge ({}, {}), expected ({}, {}), the other side of its "
                "first visit",
                root_, position, midpoint, from_of(edge), to_of(edge), to_of(awaited), from_of(awaited));
        return !report_.full();
    }

    void check_leftovers() {
        if (progress_.position != hierarchy_.node_count())
            report_.add("{} nodes follow the last root's tree", hierarchy_.node_count() - progress_.position);
        const std::size_t used = hierarchy_.node_count() % 64;
        if (used != 0 && hierarchy_.bits.back() >> used != 0)
            report_.add("bits after the last node are set, expected 0");
        if (progress_.midpoint != hierarchy_.midpoints.size())
            report_.add("{} midpoints are left over", hierarchy_.midpoints.size() - progress_.midpoint);
        if (progress_.next_vertex != hierarchy_.positions.size())
            report_.add("vertex {} is no midpoint; {} vertices are used by no node", progress_.next_vertex,
                        hierarchy_.positions.size() - progress_.next_vertex);
        if (progress_.open == 0) return;
        for (std::size_t v = hierarchy_.roots.vertex_count(); v < progress_.next_vertex && !report_.full();
             ++v)
            if (edges_[v] != closed)
                report_.add(
                    "vertex {} bisects edge ({}, {}) on one side only: it is a hanging node on the other", v,
                    from_of(edges_[v]), to_of(edges_[v]));
    }

    const Hierarchy& hierarchy_;
    Report& report_;
    /// By visited vertex: the edge of its first visit while the visit from the other side is outstanding.
    Buffer<std::uint64_t> edges_;
    std::array<PendingNode, max_level + 2> stack_;  ///< at most one node more than there are levels
    std::size_t root_ = 0;
    Progress progress_;
};

}  // namespace

std::vector<std::string> check(const Hierarchy& hierarchy, std::size_t limit) {
    Report report(limit);
    if (check_sizes(hierarchy, report)) {
        Walk(hierarchy, report).run();
        check_positions(hierarchy, report);
        check_fields(hierarchy, report);
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
            violations.push_back(fmt::format("key {} has different roots from key 0: {}", key, found));
    }
    return violations;
}

}  // namespace interleaf
