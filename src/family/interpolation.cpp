#include "family/interpolation.h"

#include <algorithm>
#include <array>

namespace interleaf {

namespace {

Weights linear_weights(std::span<const TimelineKey> keys, double time) {
    if (keys.size() == 1) return {{keys.front().key, 1}};
    // The end belongs to the last interval, so the search leaves it out.
    const auto after = std::upper_bound(keys.begin() + 1, keys.end() - 1, time,
                                        [](double t, const TimelineKey& key) { return t < key.time; });
    const TimelineKey& from = *(after - 1);
    const TimelineKey& to = *after;
    if (from.key == to.key) return {{from.key, 1}};
    const double s = (time - from.time) / (to.time - from.time);
    return sorted_weights({{from.key, 1 - s}, {to.key, s}});
}

struct Basis {
    std::string_view name;
    Weights (*weights)(std::span<const TimelineKey> keys, double time);
};

constexpr std::array offered{Interpolation::linear};

/// One row for each enumerator, in their order.
constexpr std::array<Basis, offered.size()> bases{{
    {"linear", linear_weights},
}};

const Basis& basis_of(Interpolation interpolation) {
    return bases.at(static_cast<std::size_t>(interpolation));
}

}  // namespace

std::span<const Interpolation> interpolations() {
    return offered;
}

std::string_view name_of(Interpolation interpolation) {
    return basis_of(interpolation).name;
}

std::optional<Interpolation> interpolation_named(std::string_view name) {
    const auto* const found =
        std::ranges::find(offered, name, [](Interpolation each) { return name_of(each); });
    return found == offered.end() ? std::nullopt : std::optional(*found);
}

Weights weights_at(Interpolation interpolation, std::span<const TimelineKey> keys, double time) {
    return basis_of(interpolation).weights(keys, time);
}

}  // namespace interleaf
