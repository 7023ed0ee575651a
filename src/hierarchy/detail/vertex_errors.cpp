#include "hierarchy/detail/vertex_errors.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <queue>
#include <span>
#include <utility>

#include "hierarchy/detail/bisected_nodes.h"
#include "hierarchy/detail/deviation.h"

namespace interleaf {

namespace {

constexpr float no_error = -1;

/// A bisected triangle: the vertices and triangles that bisecting it involves.
struct Bisection {
    Index newest;                                          ///< the vertex that must exist before
    std::array<Index, 2> children = {no_index, no_index};  ///< those that are bisected, too
};

/// The bisections of a hierarchy, by their places in Hierarchy::midpoints.
struct BisectionForest {
    std::vector<Bisection> bisections;
    std::vector<Index> roots;              ///< the bisected roots
    std::vector<std::array<Index, 2>> at;  ///< by vertex: the bisections that have it as their midpoint
};

BisectionForest forest_of(const Hierarchy& hierarchy) {
    BisectionForest forest;
    forest.bisections.reserve(hierarchy.midpoints.size());
    forest.at.assign(hierarchy.vertex_count(), {no_index, no_index});
    std::array<Index, max_level> path{};  // the present node and the nodes above it, by level
    for_each_bisected_node(hierarchy, [&](const BisectedNode& node) {
        forest.bisections.push_back({node.vertices[0]});
        forest.at[node.midpoint][node.is_first_visit ? 0 : 1] = node.place;
        path[node.level] = node.place;
        if (node.level == 0)
            forest.roots.push_back(node.place);
        else
            forest.bisections[path[node.level - 1]].children[node.child] = node.place;
    });
    return forest;
}

/// A triangle that exists and is bisected next if its error is the largest.
struct TriangleToBisect {
    float error;
    Index place;

    bool operator<(const TriangleToBisect& other) const {
        return error != other.error ? error < other.error : place > other.place;
    }
};

/// The refinement that determines the errors.
class ErrorRefinement {
  public:
    explicit ErrorRefinement(const Hierarchy& hierarchy)
        : midpoints_(hierarchy.midpoints),
          deviations_(deviations(hierarchy)),
          forest_(forest_of(hierarchy)),
          errors_(hierarchy.vertex_count(), no_error) {
        std::fill_n(errors_.begin(), hierarchy.roots.vertex_count(), std::numeric_limits<float>::infinity());
    }

    std::vector<float> run() && {
        for (const Index root : forest_.roots) candidates_.push({deviations_[root], root});
        while (!candidates_.empty()) {
            const auto [error, place] = candidates_.top();
            candidates_.pop();
            if (errors_[midpoints_[place]] == no_error) make(midpoints_[place], error);
        }
        return std::move(errors_);
    }

  private:
    /// Makes \p vertex, and before it all vertices that it depends on.
    void make(Index vertex, float error) {
        made_.clear();
        const auto add = [&](Index each) {
            if (errors_[each] != no_error) return;
            errors_[each] = error;
            made_.push_back(each);
        };
        add(vertex);
        for (std::size_t n = 0; n < made_.size(); ++n)
            for (const Index place : forest_.at[made_[n]])
                if (place != no_index) add(forest_.bisections[place].newest);
        for (const Index each : made_)
            for (const Index place : forest_.at[each])
                if (place != no_index) add_children(place, error);
    }

    void add_children(Index place, float error) {
        for (const Index child : forest_.bisections[place].children)
            if (child != no_index && errors_[midpoints_[child]] == no_error)
                candidates_.push({std::min(error, deviations_[child]), child});
    }

    std::span<const Index> midpoints_;
    std::vector<float> deviations_;
    BisectionForest forest_;
    std::vector<float> errors_;
    std::vector<Index> made_;
    std::priority_queue<TriangleToBisect> candidates_;
};

}  // namespace

std::vector<float> vertex_errors(const Hierarchy& hierarchy) {
    return ErrorRefinement(hierarchy).run();
}

}  // namespace interleaf
