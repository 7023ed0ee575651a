// Weights: what everything that drives a morph yields (paper, equations (2) to (5)).
#pragma once

#include <cstddef>
#include <vector>

namespace interleaf {

struct Weight {
    std::size_t key;  ///< index of the key in its family
    double value;     ///< any real number, used as given
    bool operator==(const Weight&) const = default;
};

/// Sparse weights, keys ascending and each once. A key with a place here is active, also where its value is
/// 0: the union is made of the active keys and stays while only values change.
using Weights = std::vector<Weight>;

/// The same weights with keys ascending; values of a key that occurs more than once are added.
Weights sorted_weights(Weights weights);

/// The active keys, ascending.
std::vector<std::size_t> active_keys(const Weights& weights);

/// The values, in the order of active_keys(), as the morph takes them.
std::vector<float> weight_values(const Weights& weights);

}  // namespace interleaf
