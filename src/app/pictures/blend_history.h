// Area, volume and leaves of the blend at times of the timeline or of the path, measured on a separate thread:
// first at a few times and at the keys, then at times between them.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "app/pictures/measured_series.h"
#include "family/family.h"
#include "ui/timeline/blend_plots.h"

namespace interleaf {

class BlendHistory {
  public:
    /// Begins to measure the blend of \p family over its time, unless that is what it measures already. An edit that
    /// does not change the blend at any time, such as another name, changes nothing here.
    /// \param family  null for nothing to measure
    void follow(const std::shared_ptr<const Family>& family);

    /// The curves as far as they are measured.
    const BlendCurves& curves() { return curves_.series(); }

    bool is_working() const { return curves_.is_working(); }

  private:
    std::shared_ptr<const Family> family_;
    MeasuredSeries<BlendCurves> curves_;
};

/// Whether two families have the same blend at every time.
bool have_same_blends(const Family& a, const Family& b);

}  // namespace interleaf
