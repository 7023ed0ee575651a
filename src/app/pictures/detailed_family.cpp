#include "app/pictures/detailed_family.h"

#include <algorithm>
#include <utility>

#include "hierarchy/detail/vertex_errors.h"

namespace interleaf {

namespace {

/// Keys that are measured but not active, so that scrubbing back does not measure them again.
constexpr std::size_t max_unused = 8;

}  // namespace

void DetailedFamily::follow(const Family& family, const Weights& weights, float detail) {
    source_ = &family;
    is_whole_ = detail >= 1;
    sources_.clear();
    if (is_whole_) {
        weights_ = weights;
        return;
    }
    for (MeasuredKey& key : measured_) key.is_used = false;
    levels_ = {};
    weights_.clear();
    for (const Weight& weight : weights) add(family.keys[weight.key], weight.key, weight.value, detail);
    forget_unused();
}

void DetailedFamily::add(const Key& key, std::size_t source, double weight, float detail) {
    MeasuredKey& found = measured(key.hierarchy);
    const DetailPlace place = detail_place(found.levels.size(), static_cast<double>(detail));
    const auto blend = static_cast<double>(place.blend);
    if (place.coarse != place.fine) add_level(key, source, cut_of(found, place.coarse), weight * (1 - blend));
    add_level(key, source, cut_of(found, place.fine), place.coarse == place.fine ? weight : weight * blend);
    std::erase_if(found.cuts,
                  [&](const auto& cut) { return cut.first != place.coarse && cut.first != place.fine; });
}

void DetailedFamily::add_level(const Key& key, std::size_t source, SharedHierarchy level, double weight) {
    weights_.push_back({levels_.keys.size(), weight});
    levels_.keys.push_back({key.name, std::move(level)});
    sources_.push_back(source);
}

DetailedFamily::MeasuredKey& DetailedFamily::measured(const SharedHierarchy& hierarchy) {
    const auto found = std::ranges::find_if(
        measured_, [&](const MeasuredKey& key) { return key.hierarchy.is_same(hierarchy); });
    if (found != measured_.end()) {
        found->is_used = true;
        return *found;
    }
    std::vector<float> errors = vertex_errors(*hierarchy);
    std::vector<DetailLevel> levels = detail_levels(CutSizes(*hierarchy, errors));
    measured_.push_back(
        {.hierarchy = hierarchy, .errors = std::move(errors), .levels = std::move(levels), .cuts = {}});
    return measured_.back();
}

SharedHierarchy DetailedFamily::cut_of(MeasuredKey& key, std::size_t level) {
    if (level + 1 == key.levels.size()) return key.hierarchy;
    const auto found = key.cuts.find(level);
    if (found != key.cuts.end()) return found->second;
    return key.cuts.emplace(level, cut(*key.hierarchy, key.errors, key.levels[level].threshold))
        .first->second;
}

void DetailedFamily::forget_unused() {
    std::size_t unused = 0;
    for (std::size_t i = measured_.size(); i-- > 0;) {
        if (measured_[i].is_used) continue;
        measured_[i].cuts.clear();
        if (++unused > max_unused) measured_.erase(measured_.begin() + static_cast<std::ptrdiff_t>(i));
    }
}

}  // namespace interleaf
