// Edits of weights: one weight set, a key made active or inactive, the sum made 1.
#pragma once

#include <cstddef>
#include <optional>

#include "family/weights.h"

namespace interleaf {

/// \p weights with \p key active at \p value.
Weights with_weight(Weights weights, std::size_t key, double value);

/// \p weights without \p key. The last active key stays, because a blend needs one.
Weights without_key(Weights weights, std::size_t key);

double sum_of(const Weights& weights);

/// \p weights divided by their sum; none if the sum is 0 or so close to 0 that the quotients are useless.
std::optional<Weights> summed_to_one(Weights weights);

}  // namespace interleaf
