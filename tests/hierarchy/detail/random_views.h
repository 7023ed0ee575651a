// Random views of random keys, and the refinements that suit them.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "hierarchy/detail/key_detail.h"
#include "hierarchy/detail/view_refinement.h"
#include "hierarchy/random_families.h"

namespace interleaf::testing {

/// A view from outside or inside of the cube from -1 to 1.
ViewPoint random_view(Random& random);

/// Weights whose sum is 1; one of them may be negative.
std::vector<float> random_weights(Random& random, std::size_t count);

/// The view between \p a and \p b at \p part, 0 to 1.
ViewPoint between(const ViewPoint& a, const ViewPoint& b, float part);

/// The keys of a family with their details.
struct DetailedKeys {
    explicit DetailedKeys(const std::vector<Hierarchy>& family);
    ViewRefinement refinement() const;

    std::vector<const Hierarchy*> keys;
    std::vector<KeyDetail> details;
};

/// Runs \p test on random families with their details. A failure names the family's seed.
/// \param test  takes the family, random numbers of its seed, and the details
void for_random_details(unsigned count, std::size_t keys,
                        const std::function<void(const RandomFamily&, Random&, const DetailedKeys&)>& test);

}  // namespace interleaf::testing
