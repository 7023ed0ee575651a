#include "app/pictures/field_history.h"

#include <algorithm>
#include <utility>

#include "family/family_time.h"

namespace interleaf {

bool FieldHistory::are_same(const MeasuredKeys& a, const MeasuredKeys& b) {
    return std::ranges::equal(a, b, [](const MeasuredKey& x, const MeasuredKey& y) {
        return x.time == y.time && x.hierarchy.is_same(y.hierarchy);
    });
}

void FieldHistory::follow(const std::shared_ptr<const Family>& family, const std::string* field) {
    const std::string name = field != nullptr ? *field : std::string();
    if (family == family_ && name == field_) return;
    family_ = family;
    MeasuredKeys wanted;
    if (!name.empty() && family->timeline)
        for (const TimelineKey& key : family->timeline->keys()) {
            const SharedHierarchy& hierarchy = family->keys[key.key].hierarchy;
            if (find_field(hierarchy->fields, {name, FieldKind::scalar}) != nullptr)
                wanted.push_back({key.time, hierarchy});
        }
    const FieldScale scale = family ? scale_of(family->field_scales, name) : FieldScale();
    unit_ = scale.unit;
    time_unit_ = family && family->timeline ? unit_name_of(*family, TimeSource::keys) : "";
    const bool is_same_offset = scale.offset == std::exchange(offset_, scale.offset);
    const bool is_same_field = name == std::exchange(field_, name) && is_same_offset;
    if (is_same_field && are_same(wanted, wanted_)) return;
    const MeasuredKeys known = is_same_field ? measured_.series() : MeasuredKeys();
    wanted_ = wanted;
    if (wanted.empty()) return measured_.clear();
    measured_.begin([wanted = std::move(wanted), known, name, offset = offset_](
                        const std::stop_token& stop, const MeasuredSeries<MeasuredKeys>::Publish& publish) {
        for (MeasuredKey key : wanted) {
            if (stop.stop_requested()) return;
            const auto same = std::ranges::find_if(
                known, [&](const MeasuredKey& each) { return each.hierarchy.is_same(key.hierarchy); });
            key.figures =
                same != known.end()
                    ? same->figures
                    : figures_of(*key.hierarchy,
                                 *find_field(key.hierarchy->fields, {name, FieldKind::scalar}), offset);
            publish([&](MeasuredKeys& keys) { keys.push_back(key); });
        }
    });
}

const FieldCurves& FieldHistory::curves() {
    const MeasuredKeys& keys = measured_.series();
    curves_ = {};
    curves_.unit = unit_;
    curves_.time_unit = time_unit_;
    for (const auto& [time, hierarchy, figures] : keys) {
        curves_.times.push_back(time);
        curves_.integrals.push_back(figures.integral);
        curves_.least.push_back(figures.least);
        curves_.most.push_back(figures.most);
    }
    return curves_;
}

}  // namespace interleaf
