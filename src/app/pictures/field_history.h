// The figures of the shown field at all keys of the timeline, measured on a separate thread.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "app/pictures/measured_series.h"
#include "family/family.h"
#include "family/field_figures.h"
#include "ui/panels/field_curves.h"

namespace interleaf {

class FieldHistory {
  public:
    /// Begins to measure the scalar \p field of \p family, unless that is what it measures already: an edit that
    /// leaves the keys on the timeline and their times as they are changes nothing here. Keys that were measured
    /// before are not measured again.
    /// \param field  null for none
    void follow(const std::shared_ptr<const Family>& family, const std::string* field);

    /// The curves that are measured so far, from the first key on.
    const FieldCurves& curves();

    bool is_working() const { return measured_.is_working(); }

  private:
    /// A key of the timeline with its figures.
    struct MeasuredKey {
        double time;
        SharedHierarchy hierarchy;
        FieldFigures figures{};
    };
    using MeasuredKeys = std::vector<MeasuredKey>;

    static bool are_same(const MeasuredKeys& a, const MeasuredKeys& b);

    std::shared_ptr<const Family> family_;
    std::string field_;  ///< empty for none
    double offset_ = 0;  ///< of the field (family/field_scale.h)
    std::string unit_;
    std::string time_unit_;
    MeasuredKeys wanted_;  ///< the keys of the timeline that have the field
    MeasuredSeries<MeasuredKeys> measured_;
    FieldCurves curves_;
};

}  // namespace interleaf
