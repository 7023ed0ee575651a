#include "io/gltf/weight_animation.h"

#include <algorithm>
#include <cmath>

#include "family/family_time.h"

namespace interleaf {

namespace {

constexpr double samples_per_second = 30;
constexpr double max_samples = 100'000;

/// \p times, with equal steps of at most 1/30 second between them. Long times have fewer samples.
std::vector<double> sampled(const std::vector<double>& times) {
    std::vector<double> all{times.front()};
    const double rate = std::min(samples_per_second, max_samples / (times.back() - times.front()));
    for (std::size_t i = 0; i + 1 < times.size(); ++i) {
        const double length = times[i + 1] - times[i];
        const auto steps = static_cast<std::size_t>(std::max(1.0, std::ceil(length * rate - 1e-9)));
        for (std::size_t s = 1; s < steps; ++s)
            all.push_back(times[i] + length * static_cast<double>(s) / static_cast<double>(steps));
        all.push_back(times[i + 1]);
    }
    return all;
}

}  // namespace

std::vector<float> target_weights(const Weights& weights, std::span<const std::size_t> targets) {
    std::vector<float> values;
    values.reserve(targets.size());
    for (const std::size_t key : targets) {
        const auto found = std::ranges::find(weights, key, &Weight::key);
        values.push_back(found == weights.end() ? 0.0F : static_cast<float>(found->value));
    }
    return values;
}

std::optional<WeightAnimation> weight_animation(const Family& family, std::span<const std::size_t> targets) {
    const std::optional<TimeSource> source = source_of_time(family);
    if (!source) return std::nullopt;
    std::vector<double> times = marked_times(family, *source);
    if (times.size() < 2) return std::nullopt;
    const bool is_path = *source == TimeSource::path;
    const Basis basis = is_path ? Basis::bernstein : family.timeline->interpolation().basis;
    WeightAnimation animation{.name = is_path ? "path" : "timeline", .is_stepped = basis == Basis::hold};
    if (basis != Basis::linear && basis != Basis::hold) times = sampled(times);
    animation.delay = std::max(0.0, -times.front());
    for (const double time : times) {
        const auto shown = static_cast<float>(time + animation.delay);
        if (!animation.times.empty() && shown <= animation.times.back()) continue;  // the same as a float
        const Weights weights = weights_at(family, time, *source);
        for (const Weight& weight : weights) {
            animation.least = std::min(animation.least, weight.value);
            animation.most = std::max(animation.most, weight.value);
        }
        const std::vector<float> row = target_weights(weights, targets);
        animation.times.push_back(shown);
        animation.weights.insert(animation.weights.end(), row.begin(), row.end());
    }
    if (animation.times.size() < 2) return std::nullopt;
    return animation;
}

}  // namespace interleaf
