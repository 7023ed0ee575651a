#include "app/pictures/blend_history.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <span>
#include <utility>

#include <glm/geometric.hpp>

#include "family/family_time.h"
#include "hierarchy/morph.h"

namespace interleaf {

namespace {

/// Intervals of equal length between samples: in the first pass and in the last one. Each pass has twice as many as
/// the pass before.
constexpr int first_intervals = 8;
constexpr int last_intervals = 128;

/// More keys than this are not samples of their own: the other samples are dense enough.
constexpr std::size_t max_marks = 64;

/// The family's blends, one after the other. The union is made only where the active keys change.
class BlendMeter {
  public:
    BlendMeter(const Family& family, TimeSource source) : family_(family), source_(source) {}

    BlendSample at(double time) {
        const Weights weights = weights_at(family_, time, source_);
        if (const auto active = active_keys(weights); active != active_) {
            unite(family_, weights, mesh_);
            set_blend(mesh_, family_.blend);
            active_ = active;
        }
        morph(mesh_, weight_values(weights), positions_);
        BlendSample sample{
            .time = time, .area = 0, .volume = 0, .leaves = static_cast<double>(mesh_.leaf_count())};
        const glm::dvec3 origin(positions_.front());  // keeps the terms of the volume small
        for (const auto& [a, b, c] : mesh_.triangles) {
            const glm::dvec3 from = glm::dvec3(positions_[a]) - origin;
            const glm::dvec3 normal = glm::cross(glm::dvec3(positions_[b]) - origin - from,
                                                 glm::dvec3(positions_[c]) - origin - from);
            sample.area += glm::length(normal) / 2;
            sample.volume += glm::dot(from, normal) / 6;
        }
        return sample;
    }

  private:
    const Family& family_;
    TimeSource source_;
    UnionMesh mesh_;
    std::vector<std::size_t> active_;
    Buffer<glm::vec3> positions_;
};

void measure_blends(const Family& family, TimeSource source, const std::stop_token& stop,
                    const MeasuredSeries<BlendCurves>::Publish& publish) {
    const TimeRange range = interval_of(family, source);
    BlendMeter meter(family, source);
    const std::vector<double> marks = marked_times(family, source);
    std::set<double> wanted;
    if (marks.size() <= max_marks) wanted.insert(marks.begin(), marks.end());
    std::set<double> known;
    for (int intervals = first_intervals; intervals <= last_intervals; intervals *= 2) {
        for (int n = 0; n <= intervals; ++n)
            wanted.insert(std::lerp(range.begin, range.end, double(n) / intervals));
        for (const double time : wanted) {
            if (stop.stop_requested()) return;
            if (!known.insert(time).second) continue;
            const BlendSample sample = meter.at(time);
            publish([&](BlendCurves& curves) {
                curves.insert(std::ranges::upper_bound(curves, time, {}, &BlendSample::time), sample);
            });
        }
    }
}

}  // namespace

bool have_same_blends(const Family& a, const Family& b) {
    const auto source = source_of_time(a);
    if (source != source_of_time(b) || a.blend != b.blend) return false;
    if (!source) return true;
    const bool has_same_time =
        *source == TimeSource::keys ? a.timeline == b.timeline : a.path == b.path && a.domain == b.domain;
    return has_same_time && std::ranges::equal(a.keys, b.keys, [](const Key& x, const Key& y) {
               return x.hierarchy.is_same(y.hierarchy);
           });
}

void BlendHistory::follow(const std::shared_ptr<const Family>& family) {
    if (family == family_) return;
    const bool is_same = family != nullptr && family_ != nullptr && have_same_blends(*family, *family_);
    family_ = family;
    if (is_same) return;
    const auto source = family != nullptr ? source_of_time(*family) : std::nullopt;
    if (!source) return curves_.clear();
    curves_.begin([family, source = *source](const std::stop_token& stop,
                                             const MeasuredSeries<BlendCurves>::Publish& publish) {
        measure_blends(*family, source, stop, publish);
    });
}

}  // namespace interleaf
