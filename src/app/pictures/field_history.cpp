#include "app/pictures/field_history.h"

#include <new>

#include "family/family_time.h"

namespace interleaf {

void FieldHistory::follow(const std::shared_ptr<const Family>& family, const std::string* field) {
    const bool is_same = family == family_ && field_.has_value() == (field != nullptr) &&
                         (field == nullptr || *field_ == *field);
    if (is_same) return;
    thread_ = {};  // ends the work that is no longer wanted
    family_ = family;
    field_ = field != nullptr ? std::optional(*field) : std::nullopt;
    curves_ = measured_ = {};
    is_taken_ = is_over_ = field == nullptr || !family->timeline;
    if (is_over_) return;
    measured_.unit = scale_of(family->field_scales, *field).unit;
    measured_.time_unit = unit_name_of(*family, TimeSource::keys);
    thread_ = std::jthread([this, family, name = *field](const std::stop_token& stop) {
        try {
            measure(stop, *family, name);
        } catch (const std::bad_alloc&) {  // NOLINT(bugprone-empty-catch)
            // The curves end here: without them the window still shows everything else.
        }
        const std::scoped_lock lock(mutex_);
        is_over_ = true;
    });
}

void FieldHistory::measure(const std::stop_token& stop, const Family& family, const std::string& field) {
    const double offset = scale_of(family.field_scales, field).offset;
    for (const TimelineKey& key : family.timeline->keys()) {
        if (stop.stop_requested()) return;
        const Hierarchy& hierarchy = *family.keys[key.key].hierarchy;
        const Field* const found = find_field(hierarchy.fields, {field, FieldKind::scalar});
        if (found != nullptr) add(key.time, figures_of(hierarchy, *found, offset));
    }
}

void FieldHistory::add(double time, const FieldFigures& figures) {
    const std::scoped_lock lock(mutex_);
    measured_.times.push_back(time);
    measured_.integrals.push_back(figures.integral);
    measured_.least.push_back(figures.least);
    measured_.most.push_back(figures.most);
}

const FieldCurves& FieldHistory::curves() {
    if (is_taken_) return curves_;
    const std::scoped_lock lock(mutex_);
    curves_ = measured_;
    is_taken_ = is_over_;
    return curves_;
}

}  // namespace interleaf
