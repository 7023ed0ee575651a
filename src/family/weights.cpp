#include "family/weights.h"

#include <algorithm>

namespace interleaf {

Weights sorted_weights(Weights weights) {
    std::stable_sort(weights.begin(), weights.end(),
                     [](const Weight& a, const Weight& b) { return a.key < b.key; });
    Weights sums;
    sums.reserve(weights.size());
    for (const Weight& weight : weights) {
        if (!sums.empty() && sums.back().key == weight.key) {
            sums.back().value += weight.value;
        } else {
            sums.push_back(weight);
        }
    }
    return sums;
}

std::vector<std::size_t> active_keys(const Weights& weights) {
    std::vector<std::size_t> keys;
    keys.reserve(weights.size());
    for (const Weight& weight : weights) keys.push_back(weight.key);
    return keys;
}

std::vector<float> weight_values(const Weights& weights) {
    std::vector<float> values;
    values.reserve(weights.size());
    for (const Weight& weight : weights) values.push_back(static_cast<float>(weight.value));
    return values;
}

}  // namespace interleaf
