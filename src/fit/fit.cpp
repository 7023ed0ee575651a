#include "fit/fit.h"

#include <algorithm>
#include <array>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <tuple>
#include <utility>

#include <fmt/core.h>

#include "fit/aligned_map.h"
#include "fit/correspondence/continued_map.h"
#include "fit/landmark_fitting.h"
#include "fit/landmarks/pinned_map.h"
#include "fit/map_choice.h"
#include "fit/match_to_model.h"
#include "fit/sampling/sampled_fields.h"
#include "fit/sampling/surface_sampling.h"
#include "hierarchy/error.h"

namespace interleaf {
namespace {

constexpr double min_tolerance = 1e-5;

/// A tolerance that needs more leaves than this is out of reach.
constexpr Index max_leaves = 4000000;

/// Between the measured places of a leaf, its distance may be larger by this fraction.
constexpr double sampling_margin = 0.1;

/// Maximum number of attempts to meet a tolerance by sampling with a smaller one.
constexpr int max_tries = 4;

/// The fractions of the whole work at which the stages begin, for a mesh with a few ten thousand vertices.
constexpr double map_begins = 0.1;
constexpr double second_map_begins = 0.9;
constexpr double last_map_begins = 0.95;

/// The fractions of the way from a clean mesh to its key at which the map is chosen and judged.
constexpr double chosen_at = 0.7;
constexpr double judged_at = 0.87;

/// The fraction at which a map is chosen that is matched to a model's.
constexpr double chosen_before_match = 0.1;

/// Where a map is continued, shapes on the sphere are restored where their distortion is larger than the first of
/// these; where that gives no good key, than the next. The more is restored, the further points slide.
constexpr std::array<double, 3> continued_shapes = {4, 2, 1.3};

void check_options(const FitOptions& options) {
    if (options.leaves && options.tolerance)
        throw UsageError("a number of leaves and a tolerance exclude each other");
    const Index roots = options.roots.complex.triangle_count();
    if (options.leaves && *options.leaves < roots)
        throw UsageError(fmt::format("{} leaves are too few: there are {} roots", *options.leaves, roots));
    if (options.tolerance && !(*options.tolerance >= min_tolerance))
        throw UsageError(fmt::format("the tolerance must be at least {}", min_tolerance));
    check_directions(options.landmarks);
    if (!options.counterparts.empty() && options.counterparts.size() != options.landmarks.size())
        throw UsageError(fmt::format("{} counterparts, expected one for each of the {} landmarks",
                                     options.counterparts.size(), options.landmarks.size()));
}

/// The landmarks to which a key is to be near: none if they are not pinned, so that they do not change the first key.
std::vector<glm::dvec3> pinned_positions(std::span<const Landmark> landmarks, const LandmarkPins* pins) {
    std::vector<glm::dvec3> positions;
    if (pins == nullptr) return positions;
    positions.reserve(landmarks.size());
    for (const Landmark& landmark : landmarks) positions.push_back(landmark.position);
    return positions;
}

/// Samples and smooths.
SampledSurface leaves_over(const AlignedMap& map, const SphereRoots& roots, const SamplingOptions& options,
                           double accepted_distance, const Progress& progress) {
    SampledSurface surface = sample_surface(map.mapped, roots, options, part_of(progress, 0, 0.5));
    smooth(map, roots, surface, accepted_distance, part_of(progress, 0.5, 1));
    return surface;
}

/// Samples until the measured distance is within \p tolerance, a fraction of the box diagonal.
std::pair<SampledSurface, FitQuality> sample_within(const AlignedMap& map, const SphereRoots& roots,
                                                    double tolerance, const Progress& progress) {
    const double diagonal = box_diagonal(map.original);
    double inside = tolerance * (1 - sampling_margin);
    for (int tries = 1;; ++tries) {
        SampledSurface surface = leaves_over(
            map, roots, {.leaves = max_leaves, .tolerance = inside * diagonal}, tolerance, progress);
        if (surface.leaves.size() + 100 > max_leaves)
            throw InputError(
                fmt::format("a tolerance of {} needs more than {} leaves", tolerance, max_leaves));
        const FitQuality quality = quality_of(map, surface, progress);
        if (quality.hausdorff <= tolerance) return {std::move(surface), quality};
        if (tries == max_tries)
            throw InputError(
                fmt::format("a tolerance of {} cannot be reached: {:.3g} is what {} leaves come to",
                            tolerance, quality.hausdorff, surface.leaves.size()));
        inside *= std::max(0.25, (1 - sampling_margin) * tolerance / quality.hausdorff);
    }
}

/// Accepts or refuses a map, samples it as the options demand, and makes the key.
/// \param pins  null for none
FittedKey key_of(JudgedMap judged, const FitOptions& options, const LandmarkPins* pins,
                 std::vector<StageTime> times, const Progress& progress) {
    require_accepted(judged, options.limits, pins);
    const AlignedMap& map = *judged.map;
    SampledSurface surface = std::move(judged.surface);
    FittedKey key;
    FitReport& report = key.report;
    report.mesh_vertices = map.original.positions.size();
    report.mesh_triangles = map.original.triangles.size();
    report.map_method = judged.method;
    report.mean_cosine = map.mean_cosine;
    key.fine_mesh = map.fine;
    key.points = map.points;
    report.at_20000_leaves = report.quality = judged.quality;
    report.times = std::move(times);
    Stopwatch stopwatch(report.times);
    const Index default_leaves = judged_leaves(options.roots);
    if (options.tolerance) {
        std::tie(surface, report.quality) = sample_within(map, options.roots, *options.tolerance, progress);
        stopwatch.lap("sampling within the tolerance");
    } else if (options.leaves.value_or(default_leaves) != default_leaves) {
        surface = leaves_over(map, options.roots, {.leaves = *options.leaves}, options.limits.hausdorff,
                              part_of(progress, 0, 0.4));
        stopwatch.lap("sampling");
        report.quality = quality_of(map, surface, part_of(progress, 0.4, 1));
        stopwatch.lap("measuring");
    }
    key.hierarchy = hierarchy_from_leaves(options.roots.complex, surface.leaves, surface.positions,
                                          sampled_fields(map.original, map.mapped, surface));
    report.landmarks = fitted_landmarks(options.landmarks, map, {key.hierarchy, options.roots});
    report.landmark_faults = faults_of_places(report.landmarks);
    if (pins != nullptr)
        for (std::string& text : faults_of(judged.agreement, *pins))
            report.landmark_faults.push_back(std::move(text));
    return key;
}

/// Maps a clean mesh, samples it, and accepts or refuses the key.
/// \param pins  of vertices of \p mesh; null for none
FittedKey fit_clean(const SurfaceMesh& mesh, const LandmarkPins* pins, const MappingWay& way,
                    const FitOptions& options, const Progress& progress) {
    std::vector<StageTime> times;
    Stopwatch stopwatch(times);
    const std::vector<glm::dvec3> landmarks = pinned_positions(options.landmarks, pins);
    ChosenMap chosen =
        choose_map(mesh,
                   {.roots = options.roots,
                    .rotation = options.rotation,
                    .way = way,
                    .limits = options.limits,
                    .pins = pins,
                    .landmarks = landmarks},
                   stopwatch, part_of(progress, 0, options.model ? chosen_before_match : chosen_at));
    JudgedMap judged;
    std::optional<MatchReport> match;
    if (options.model) {
        std::tie(judged, match) = match_to_model(std::move(chosen), options, pins, landmarks, stopwatch,
                                                 part_of(progress, chosen_before_match, judged_at));
    } else {
        judged = judge(std::move(chosen), options.roots, options.limits, stopwatch,
                       part_of(progress, chosen_at, judged_at));
    }
    FittedKey key =
        key_of(std::move(judged), options, pins, std::move(times), part_of(progress, judged_at, 1));
    key.report.map_keeps = way.keeps;
    key.report.match = std::move(match);
    return key;
}

/// \throw InputError  naming the changes of the clean-up that the options do not allow
void require_wanted(const CleanUpReport& report, const FitOptions& options) {
    std::string unwanted;
    for (const std::string& change : unwanted_changes(report, options.keep_largest, options.fill_holes))
        unwanted += (unwanted.empty() ? "" : "; ") + change;
    if (!unwanted.empty()) throw InputError(unwanted);
}

/// See FitReport::hausdorff_as_brought.
/// \param key  made from \p clean
double distance_as_brought(const CleanMesh& clean, const FittedKey& key, const Progress& progress) {
    // If nothing was changed, this is the distance from the clean mesh, which has already been measured.
    if (clean.report.fillings.empty() && clean.report.dropped_parts.empty())
        return key.report.quality.hausdorff;
    SurfaceMesh brought{.positions = clean.mesh.positions, .triangles = clean.mesh.triangles, .colors = {}};
    brought.triangles.resize(brought.triangles.size() - clean.report.filling_triangles());
    const auto first = static_cast<Index>(brought.positions.size());
    brought.positions.insert(brought.positions.end(), clean.dropped.positions.begin(),
                             clean.dropped.positions.end());
    for (const auto& [a, b, c] : clean.dropped.triangles)
        brought.triangles.push_back({first + a, first + b, first + c});

    const SurfaceMesh leaves = surface_of(key.hierarchy);
    return hausdorff_distance({leaves.triangles, leaves.positions}, {brought.triangles, brought.positions},
                              progress) /
           box_diagonal(brought);
}

/// \p key with the mesh that it was made from, and what the report says about it.
FittedKey of_clean_mesh(FittedKey key, CleanMesh clean) {
    key.report.mesh_vertices = clean.mesh.positions.size();
    key.report.mesh_triangles = clean.mesh.triangles.size();
    key.report.hausdorff_as_brought = distance_as_brought(clean, key, {});
    key.report.clean_up = std::move(clean.report);
    key.mesh = std::move(clean.mesh);
    return key;
}

}  // namespace

FittedKey fit_mapped(const SurfaceMesh& mesh, std::vector<glm::dvec3> points, const FitOptions& options,
                     const Progress& progress) {
    check_options(options);
    std::vector<StageTime> times;
    Stopwatch stopwatch(times);
    auto map =
        std::make_shared<AlignedMap>(mesh, SurfaceMesh{}, std::move(points), false, options.rotation, false);
    stopwatch.lap("alignment");
    JudgedMap judged =
        judge(std::move(map), options.roots, options.limits, 0, stopwatch, part_of(progress, 0, 0.5));
    return key_of(std::move(judged), options, nullptr, std::move(times), part_of(progress, 0.5, 1));
}

std::string_view name_of(MapMethod method) {
    constexpr std::array<std::string_view, 3> names = {"progressive", "careful progressive",
                                                       "curvature flow"};
    return names[static_cast<std::size_t>(method)];
}

std::string_view name_of(Keeps keeps) {
    return keeps == Keeps::shapes ? "shapes" : "areas";
}

FittedKey fit(SurfaceMesh mesh, const FitOptions& options, const Progress& progress) {
    check_options(options);
    return fit(clean_up(std::move(mesh), part_of(progress, 0, map_begins)), options,
               part_of(progress, map_begins, 1));
}

FittedKey fit(CleanMesh clean, const FitOptions& options, const Progress& progress) {
    check_options(options);
    require_wanted(clean.report, options);
    std::vector<StageTime> times;
    Stopwatch stopwatch(times);
    const std::optional<PinnedMesh> pinned =
        pinned_mesh(clean.mesh, options.landmarks, options.symmetric, options.counterparts);
    const SurfaceMesh& mesh = pinned ? pinned->mesh : clean.mesh;
    const LandmarkPins* const pins = pinned ? &pinned->pins : nullptr;
    const auto attempt = [&](const MappingWay& way, double begin, double end) -> std::optional<FittedKey> {
        try {
            return fit_clean(mesh, pins, way, options, part_of(progress, begin, end));
        } catch (const LandmarkError&) {
            throw;
        } catch (const InputError&) {
            stopwatch.lap("refused attempts");
            return std::nullopt;
        }
    };
    std::optional<FittedKey> first = attempt({}, 0, second_map_begins);
    if (!first && is_only_mapped_as_it_is(mesh))
        first = attempt({.relaxes_crowded = true}, second_map_begins, last_map_begins);
    FittedKey key = first ? *std::move(first)
                          : fit_clean(mesh, pins, {.keeps = Keeps::areas}, options,
                                      part_of(progress, last_map_begins, 1));
    key.report.times.insert(key.report.times.begin(), times.begin(), times.end());
    return of_clean_mesh(std::move(key), std::move(clean));
}

std::optional<FittedKey> fit_continued(const CleanMesh& clean, const FittedKey& before,
                                       const FitQuality& wanted, const FitOptions& options,
                                       const Progress& progress) {
    check_options(options);
    require_wanted(clean.report, options);
    double reached = 0;
    const Progress onward = [&](std::string_view stage, double part) {
        reached = std::max(reached, part);  // a failed attempt may have come further than the next one begins
        return !progress || progress(stage, reached);
    };
    std::vector<StageTime> times;
    Stopwatch stopwatch(times);
    const ContinuedMap map = continued_map(before.mapped_mesh(), before.points, clean.mesh,
                                           options.matching.vertices, part_of(onward, 0, 0));
    stopwatch.lap("continuing the map");
    if (map.points.empty()) return std::nullopt;
    double end = 0;
    for (const double worst_shape : continued_shapes) {
        const double begin = end;
        end += judged_at / double(continued_shapes.size());
        std::vector<glm::dvec3> points =
            with_restored_shapes(map, worst_shape, part_of(onward, begin, begin));
        stopwatch.lap("continuing the map");
        if (points.empty()) break;
        try {
            JudgedMap judged = judge(
                std::make_shared<AlignedMap>(clean.mesh, map.mesh, std::move(points), false), options.roots,
                options.limits, wanted_angle(wanted), stopwatch, part_of(onward, begin, end));
            if (fault_of_match(judged, wanted, options.limits).empty())
                return of_clean_mesh(
                    key_of(std::move(judged), options, nullptr, times, part_of(onward, judged_at, 1)), clean);
        } catch (const InputError&) {
            continue;  // no key within the tolerance, for example; more restored shapes may give one
        }
    }
    return std::nullopt;
}

}  // namespace interleaf
