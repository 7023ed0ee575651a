#include "app/pictures/warped_family.h"

#include <algorithm>
#include <utility>

namespace interleaf {

void WarpedFamily::follow(const Family& family, const Weights& weights, std::span<const std::size_t> sources,
                          const std::optional<Warp>& warp) {
    source_ = &family;
    std::vector<WarpedKey> before = std::exchange(keys_, {});
    if (warp != warp_) before.clear();
    warp_ = warp;
    if (!warp) {
        weights_ = weights;
        sources_.assign(sources.begin(), sources.end());
        return;
    }
    warped_ = {};
    warped_.blend = family.blend;
    warped_.field_scales = family.field_scales;
    weights_.clear();
    sources_.clear();
    for (const Weight& weight : weights) {
        const Key& key = family.keys[weight.key];
        const auto known = std::ranges::find_if(
            before, [&](const WarpedKey& each) { return each.flat.is_same(key.hierarchy); });
        keys_.push_back(known != before.end() ? *known
                                              : WarpedKey{key.hierarchy, warped(*key.hierarchy, *warp)});
        weights_.push_back({warped_.keys.size(), weight.value});
        warped_.keys.push_back({key.name, keys_.back().warped});
        sources_.push_back(sources.empty() ? weight.key : sources[weight.key]);
    }
}

}  // namespace interleaf
