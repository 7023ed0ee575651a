#include "app/pictures/detailed_family.h"

#include <algorithm>
#include <utility>

#include "hierarchy/detail/cut.h"
#include "hierarchy/detail/detail_levels.h"

namespace interleaf {

void DetailedFamily::follow(const Family& family, const Weights& weights, float detail, KeyDetails& details) {
    source_ = &family;
    sources_.clear();
    std::vector<KeyDetails::Measured> measured;
    measured.reserve(weights.size());
    if (detail < 1)
        for (const Weight& weight : weights)
            measured.push_back(details.find(family.keys[weight.key].hierarchy));
    is_whole_ = detail >= 1 || std::ranges::find(measured, nullptr) != measured.end();
    if (is_whole_) {
        weights_ = weights;
        cuts_.clear();
        return;
    }
    levels_ = {};
    levels_.blend = family.blend;
    weights_.clear();
    for (std::size_t n = 0; n < weights.size(); ++n) {
        const Key& key = family.keys[weights[n].key];
        add(cuts_of(key.hierarchy, measured[n]), key, weights[n].key, weights[n].value, detail);
    }
    std::erase_if(cuts_, [&](const CutKey& cut) {
        return std::ranges::none_of(weights, [&](const Weight& weight) {
            return family.keys[weight.key].hierarchy.is_same(cut.hierarchy);
        });
    });
}

void DetailedFamily::add(CutKey& cuts, const Key& key, std::size_t source, double weight, float detail) {
    const DetailPlace place = detail_place(cuts.measured->levels.size(), static_cast<double>(detail));
    const auto blend = static_cast<double>(place.blend);
    if (place.coarse != place.fine) add_level(key, source, cut_of(cuts, place.coarse), weight * (1 - blend));
    add_level(key, source, cut_of(cuts, place.fine), place.coarse == place.fine ? weight : weight * blend);
    std::erase_if(cuts.cuts,
                  [&](const auto& cut) { return cut.first != place.coarse && cut.first != place.fine; });
}

void DetailedFamily::add_level(const Key& key, std::size_t source, SharedHierarchy level, double weight) {
    weights_.push_back({levels_.keys.size(), weight});
    levels_.keys.push_back({key.name, std::move(level)});
    sources_.push_back(source);
}

DetailedFamily::CutKey& DetailedFamily::cuts_of(const SharedHierarchy& hierarchy,
                                                KeyDetails::Measured measured) {
    const auto found =
        std::ranges::find_if(cuts_, [&](const CutKey& cut) { return cut.hierarchy.is_same(hierarchy); });
    if (found != cuts_.end()) return *found;
    return cuts_.emplace_back(CutKey{.hierarchy = hierarchy, .measured = std::move(measured)});
}

SharedHierarchy DetailedFamily::cut_of(CutKey& key, std::size_t level) {
    const KeyDetail& detail = *key.measured;
    if (level + 1 == detail.levels.size()) return key.hierarchy;
    const auto found = key.cuts.find(level);
    if (found != key.cuts.end()) return found->second;
    return key.cuts.emplace(level, cut(*key.hierarchy, detail.errors, detail.levels[level].threshold))
        .first->second;
}

}  // namespace interleaf
