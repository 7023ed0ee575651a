#include "family/weight_edits.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace interleaf {

namespace {

/// Smallest part of the sum of the absolute weights that the sum must be.
constexpr double min_relative_sum = 1e-9;

}  // namespace

Weights with_weight(Weights weights, std::size_t key, double value) {
    const auto place = std::ranges::lower_bound(weights, key, {}, &Weight::key);
    if (place != weights.end() && place->key == key)
        place->value = value;
    else
        weights.insert(place, {key, value});
    return weights;
}

Weights without_key(Weights weights, std::size_t key) {
    if (weights.size() > 1) std::erase_if(weights, [key](const Weight& weight) { return weight.key == key; });
    return weights;
}

double sum_of(const Weights& weights) {
    double sum = 0;
    for (const Weight& weight : weights) sum += weight.value;
    return sum;
}

std::optional<Weights> summed_to_one(Weights weights) {
    const double sum = sum_of(weights);
    double absolute = 0;
    for (const Weight& weight : weights) absolute += std::abs(weight.value);
    if (absolute == 0 || std::abs(sum) < min_relative_sum * absolute) return std::nullopt;
    for (Weight& weight : weights) weight.value /= sum;
    return weights;
}

}  // namespace interleaf
