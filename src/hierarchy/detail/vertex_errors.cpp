#include "hierarchy/detail/vertex_errors.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <queue>
#include <span>
#include <utility>

#include "hierarchy/detail/deviation.h"

namespace interleaf {

namespace {

constexpr float no_error = -1;

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
    ErrorRefinement(const Hierarchy& hierarchy, const BisectionForest& forest,
                    std::span<const float> deviations)
        : deviations_(deviations), forest_(forest), errors_(hierarchy.vertex_count(), no_error) {
        std::fill_n(errors_.begin(), hierarchy.roots.vertex_count(), std::numeric_limits<float>::infinity());
    }

    std::vector<float> run(const DetailProgress& progress) && {
        constexpr std::size_t between_reports = 1 << 13;
        std::size_t taken = 0;
        for (const Index root : forest_.roots)
            if (root != no_index) candidates_.push({deviations_[root], root});
        while (!candidates_.empty()) {
            const auto [error, place] = candidates_.top();
            candidates_.pop();
            if (progress && taken % between_reports == 0)
                progress(static_cast<double>(taken) / static_cast<double>(deviations_.size()));
            ++taken;
            const Index midpoint = forest_.bisections[place].midpoint;
            if (errors_[midpoint] == no_error) make(midpoint, error);
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
            if (child != no_index && errors_[forest_.bisections[child].midpoint] == no_error)
                candidates_.push({std::min(error, deviations_[child]), child});
    }

    std::span<const float> deviations_;
    const BisectionForest& forest_;
    std::vector<float> errors_;
    std::vector<Index> made_;
    std::priority_queue<TriangleToBisect> candidates_;
};

}  // namespace

std::vector<float> vertex_errors(const Hierarchy& hierarchy, const DetailProgress& progress) {
    constexpr double until_deviations = 0.6;
    const std::vector<float> deviation = deviations(hierarchy, detail_part(progress, 0, until_deviations));
    return vertex_errors(hierarchy, bisection_forest(hierarchy), deviation,
                         detail_part(progress, until_deviations, 1));
}

std::vector<float> vertex_errors(const Hierarchy& hierarchy, const BisectionForest& forest,
                                 std::span<const float> deviations, const DetailProgress& progress) {
    return ErrorRefinement(hierarchy, forest, deviations).run(progress);
}

}  // namespace interleaf
