// The timeline of a family as a glTF animation of morph weights: numbers at times, with straight lines
// between them. The linear basis is exactly that; other bases and paths are sampled 30 times per second.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "family/family.h"

namespace interleaf {

struct WeightAnimation {
    std::string_view name;       ///< "timeline" or "path"
    bool is_stepped = false;     ///< each row holds until the next time; otherwise rows are blended linearly
    std::vector<float> times{};  ///< seconds, not negative, strictly ascending; at least two
    std::vector<float> weights{};  ///< per time, the weight of each target
    double delay = 0;              ///< seconds added to the family's times, because glTF has none below 0
    double least = 0;              ///< least and largest weight of any key, the base included
    double most = 1;
};

/// The animation of what drives the blend over time.
/// \param targets  the keys of the targets, as indices in the family
/// \return         none if nothing drives the blend, or if the timeline has no duration
std::optional<WeightAnimation> weight_animation(const Family& family, std::span<const std::size_t> targets);

/// The weight of each key of \p targets; 0 for a key that is not active.
std::vector<float> target_weights(const Weights& weights, std::span<const std::size_t> targets);

}  // namespace interleaf
