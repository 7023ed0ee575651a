// Weights: the input of a morph (paper, equations (2) to (5)).
#pragma once

#include <cstddef>
#include <vector>

namespace interleaf {

struct Weight {
    std::size_t key;  ///< index of the key in its family
    double value;     ///< any real number, used as given
    bool operator==(const Weight&) const = default;
};

/// Sparse weights, keys ascending and each once. A key with an entry here is active, even if its value is 0.
/// The union is that of the active keys, and stays the same while only values change.
using Weights = std::vector<Weight>;

/// The same weights with keys ascending. Values of a key that occurs several times are added.
Weights sorted_weights(Weights weights);

/// The active keys, ascending.
std::vector<std::size_t> active_keys(const Weights& weights);

/// The values in the order of active_keys(), as the morph expects them.
std::vector<float> weight_values(const Weights& weights);

}  // namespace interleaf
