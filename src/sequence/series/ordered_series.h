// Recovery by order: all steps are coarsened by one rule, and their roots are matched from step to step.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "hierarchy/matching/root_match.h"
#include "sequence/series/order_coarsening.h"

namespace interleaf {

/// The common roots of a series, where the step that was added last has them.
struct OrderedRoots {
    RootComplex complex;
    std::vector<glm::vec3> positions;  ///< one per root vertex
};

/// Looks for a rule under which all steps of a series have the same roots.
class OrderSearch {
  public:
    /// \param newest  the only corner that may be the newest vertex; all three are tried if not set
    explicit OrderSearch(std::optional<unsigned> newest);

    /// Tries the remaining rules on the next step.
    /// \return whether a rule remains
    bool add(const StepMesh& step);

    /// The best of the remaining rules: the one with the fewest roots; of equal ones, the one with midpoints
    /// nearest to the middle of their edges.
    std::optional<OrderRule> best() const;

  private:
    struct Candidate {
        OrderRule rule;
        OrderedRoots roots;
        double deviation = 0;
    };
    bool fits(Candidate& candidate, const StepMesh& step) const;

    std::vector<Candidate> candidates_;
    bool is_first_ = true;
    std::size_t least_triangles_;
};

/// The key of \p step under \p rule, over the roots of \p roots. If these are empty, they become the roots of
/// the step. The positions of \p roots become those of the step.
/// \return none if the step has other roots
std::optional<Hierarchy> key_by_order(const StepMesh& step, const OrderRule& rule, const SeriesFields& fields,
                                      OrderedRoots& roots);

}  // namespace interleaf
