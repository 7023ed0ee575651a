#include "fit/match_to_model.h"

#include <memory>
#include <optional>
#include <string_view>
#include <variant>
#include <vector>

#include <fmt/core.h>

#include "fit/aligned_map.h"
#include "fit/correspondence/matched_body.h"
#include "fit/half_way.h"
#include "fit/landmarks/pinned_map.h"
#include "fit/mesh/parallel_work.h"
#include "fit/sampling/mapped_surface.h"
#include "fit/sampling/surface_sampling.h"
#include "hierarchy/error.h"

namespace interleaf {
namespace {

/// The key of a map without matching, which another thread judges.
class UnmatchedKey {
  public:
    /// The arguments must outlive this object, but for the first.
    UnmatchedKey(ChosenMap chosen, const FitOptions& options, const LandmarkPins* pins)
        : options_(options), pins_(pins), chosen_(std::move(chosen)) {}

    /// \throw InputError  if the key is known already, and refused
    void require_not_refused() {
        if (!is_awaited_ && work_.is_done()) get({});
    }

    /// Waits until the key is judged.
    /// \throw InputError  if it is refused
    JudgedMap& get(const Progress& progress) {
        if (!std::exchange(is_awaited_, true)) judged_ = work_.wait("measuring", progress);
        require_accepted(judged_, options_.limits, pins_);
        return judged_;
    }

  private:
    JudgedMap judge_chosen(const Progress& progress) {
        std::vector<StageTime> times;  // of work that nobody waits for
        Stopwatch stopwatch(times);
        return judge(std::move(chosen_), options_.roots, options_.limits, stopwatch, progress);
    }

    const FitOptions& options_;
    const LandmarkPins* pins_;
    ChosenMap chosen_;
    JudgedMap judged_;
    bool is_awaited_ = false;
    ParallelWork<JudgedMap> work_{[this](const Progress& progress) { return judge_chosen(progress); }};
};

/// The key of a model, to compare others with. It is not smoothed.
Hierarchy key_of_model(const MatchedBody& model, const SphereRoots& roots, const Progress& progress) {
    const SurfaceMesh mesh{
        .positions = model.mesh().positions, .triangles = model.mesh().triangles, .colors = {}};
    const SampledSurface surface =
        sample_surface(MappedSurface(mesh, model.points()), roots,
                       {.leaves = judged_leaves(roots), .max_leveling = 0}, progress);
    return hierarchy_from_leaves(roots.complex, surface.leaves, surface.positions);
}

}  // namespace

void require_accepted(const JudgedMap& judged, const FitLimits& limits, const LandmarkPins* pins) {
    const std::string fault = fault_of_fit(judged.quality, judged.surface.leaves.size(), limits);
    if (fault.empty()) return;
    const std::string text =
        fmt::format("no good key: {}{}", fault, pins != nullptr ? advice_on(judged.agreement, *pins) : "");
    if (pins != nullptr && judged.agreement.is_doubtful()) throw LandmarkError(text);
    throw InputError(text);
}

double wanted_angle(const FitQuality& unmatched) {
    constexpr double small_angle = 3;
    constexpr double good_angle = 6;
    return unmatched.min_angle > good_angle ? small_angle : 0;
}

std::string fault_of_match(const JudgedMap& matched, const FitQuality& unmatched, const FitLimits& limits) {
    constexpr double farther = 1.3;
    constexpr double margin = 2e-4;
    const FitQuality& quality = matched.quality;
    std::string fault = fault_of_fit(quality, matched.surface.leaves.size(), limits);
    if (!fault.empty()) return fault;
    if (quality.hausdorff > farther * unmatched.hausdorff + margin)
        return fmt::format("{:.3g} % of the box diagonal from the surface, {:.3g} % without matching",
                           100 * quality.hausdorff, 100 * unmatched.hausdorff);
    if (quality.min_angle < wanted_angle(unmatched))
        return fmt::format("the least angle of a leaf is {:.1f} degrees, {:.1f} without matching",
                           quality.min_angle, unmatched.min_angle);
    return {};
}

std::pair<JudgedMap, MatchReport> match_to_model(ChosenMap chosen, const FitOptions& options,
                                                 const LandmarkPins* pins,
                                                 std::span<const glm::dvec3> landmarks, Stopwatch& stopwatch,
                                                 const Progress& progress) {
    // Kept here, too: the other thread gives its own up if it throws.
    const auto kept = std::visit([](const auto& made) { return made.map; }, chosen);
    const AlignedMap& map = *kept;
    const bool are_doubtful =
        pins != nullptr &&
        !faults_of(std::visit([](const auto& made) { return made.agreement; }, chosen), *pins).empty();
    UnmatchedKey unmatched(std::move(chosen), options, pins);
    if (are_doubtful) {
        MatchReport report;
        report.fault = "landmarks are probably wrong";
        return {std::move(unmatched.get(progress)), std::move(report)};
    }
    std::optional<Hierarchy> models_key;
    const auto half_way_area_of = [&](const SampledSurface& surface) {
        return half_way_area(*models_key,
                             hierarchy_from_leaves(options.roots.complex, surface.leaves, surface.positions),
                             options.rotation);
    };
    double area_before = 0;
    double area_after = 0;
    JudgedMap judged_match;
    const auto judge_match = [&](const MatchedMap& matched, const Progress& inner) {
        stopwatch.lap("matching");
        const JudgedMap& without = unmatched.get(part_of(inner, 0, 0));
        stopwatch.lap("waiting for the key without matching");
        judged_match = judge(std::make_shared<AlignedMap>(map.original, matched.mesh, matched.points,
                                                          map.is_approximate, landmarks),
                             options.roots, options.limits, wanted_angle(without.quality), stopwatch, inner);
        if (std::string fault = fault_of_match(judged_match, without.quality, options.limits); !fault.empty())
            return fault;
        if (!models_key) {
            models_key = key_of_model(*options.model, options.roots, part_of(inner, 1, 1));
            area_before = half_way_area_of(without.surface);
        }
        area_after = half_way_area_of(judged_match.surface);
        stopwatch.lap("comparing half way");
        // Landmarks say what corresponds, and may be kept in poses in which areas half way say nothing.
        return pins != nullptr ? std::string() : fault_of_half_way(area_after, area_before);
    };
    const Progress while_not_refused = [&](std::string_view stage, double part) {
        unmatched.require_not_refused();
        return !progress || progress(stage, part);
    };
    const std::span<const Index> held = pins != nullptr ? pins->vertices : std::span<const Index>();
    MatchedMap matched = match(*options.model, map.mesh(), map.points, options.rotation, held,
                               options.matching, while_not_refused, judge_match);
    stopwatch.lap("matching");
    JudgedMap& without = unmatched.get(part_of(progress, 1, 1));
    stopwatch.lap("waiting for the key without matching");
    const bool is_matched = matched.report.fault.empty();
    matched.report.half_way_area_before = area_before;
    matched.report.half_way_area_after = is_matched ? area_after : area_before;
    if (!is_matched) return {std::move(without), std::move(matched.report)};
    judged_match.method = without.method;
    judged_match.agreement = without.agreement;
    return {std::move(judged_match), std::move(matched.report)};
}

}  // namespace interleaf
