#include "fit/fit.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <tuple>
#include <utility>

#include <fmt/core.h>
#include <glm/common.hpp>

#include "fit/alignment.h"
#include "fit/leaf_smoothing.h"
#include "fit/spherical_map.h"
#include "fit/surface_sampling.h"
#include "hierarchy/error.h"

namespace interleaf {
namespace {

constexpr Index judged_leaves = 20000;
constexpr double least_tolerance = 1e-5;

/// A tolerance that needs more leaves is out of reach.
constexpr Index most_leaves = 4000000;

/// Between the places where a leaf's distance is measured it may be this much farther.
constexpr double sampling_margin = 0.1;

/// Times that a tolerance is tried to be met with a smaller one inside.
constexpr int most_tries = 4;

/// The parts of the whole at which the stages begin, of a mesh of a few ten thousand vertices.
constexpr double map_begins = 0.1;
constexpr double second_map_begins = 0.9;

/// The same of the way from a clean mesh to its key.
constexpr double mapped_begins = 0.7;

/// Reports what a stage reports as the part of the whole from \p begin to \p end.
Progress part_of(const Progress& progress, double begin, double end) {
    if (!progress) return {};
    return [&progress, begin, end](std::string_view stage, double part) {
        return progress(stage, begin + (end - begin) * std::clamp(part, 0.0, 1.0));
    };
}

class Stopwatch {
  public:
    explicit Stopwatch(std::vector<StageTime>& times) : times_(times) {}

    /// The stage that has gone on since the last call is over.
    void lap(std::string stage) {
        const auto now = std::chrono::steady_clock::now();
        times_.push_back({std::move(stage), std::chrono::duration<double>(now - begin_).count()});
        begin_ = now;
    }

  private:
    std::vector<StageTime>& times_;
    std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

void check_options(const FitOptions& options) {
    if (options.leaves && options.tolerance)
        throw UsageError("a number of leaves and a tolerance exclude each other");
    const Index roots = options.roots.complex.triangle_count();
    if (options.leaves && *options.leaves < roots)
        throw UsageError(fmt::format("{} leaves are too few: there are {} roots", *options.leaves, roots));
    if (options.tolerance && !(*options.tolerance >= least_tolerance))
        throw UsageError(fmt::format("the tolerance must be at least {}", least_tolerance));
}

/// Samples and smooths.
SampledSurface leaves_over(const MappedSurface& mapped, const SphereRoots& roots,
                           const SamplingOptions& options, const Progress& progress) {
    SampledSurface surface = sample_surface(mapped, roots, options, part_of(progress, 0, 0.5));
    smooth_leaves(mapped, roots.complex.vertex_count(), surface, part_of(progress, 0.5, 1));
    return surface;
}

/// Samples until the measured distance is within \p tolerance, a part of the box diagonal.
std::pair<SampledSurface, FitQuality> sample_within(const MappedSurface& mapped, const SphereRoots& roots,
                                                    double tolerance, const Progress& progress) {
    const double diagonal = box_diagonal(mapped.mesh);
    double inside = tolerance * (1 - sampling_margin);
    for (int tries = 1;; ++tries) {
        SampledSurface surface =
            leaves_over(mapped, roots, {.leaves = most_leaves, .tolerance = inside * diagonal}, progress);
        if (surface.leaves.size() + 100 > most_leaves)
            throw InputError(
                fmt::format("a tolerance of {} needs more than {} leaves", tolerance, most_leaves));
        const FitQuality quality = measure_quality(mapped, surface, progress);
        if (quality.hausdorff <= tolerance) return {std::move(surface), quality};
        if (tries == most_tries)
            throw InputError(
                fmt::format("a tolerance of {} cannot be reached: {:.3g} is what {} leaves come to",
                            tolerance, quality.hausdorff, surface.leaves.size()));
        inside *= std::max(0.25, (1 - sampling_margin) * tolerance / quality.hausdorff);
    }
}

/// The colours of the mesh at the sampled points, as the field "color"; none for a mesh without.
std::vector<Field> color_fields(const SurfaceMesh& mesh, const SampledSurface& surface) {
    if (mesh.colors.empty()) return {};
    Field field{"color", FieldKind::color, {}};
    field.values.reserve(3 * surface.mesh_points.size());
    for (const MeshPoint& point : surface.mesh_points) {
        const glm::vec3 color =
            glm::clamp(point.of(std::span(mesh.triangles), std::span(mesh.colors)), 0.0F, 1.0F);
        field.values.insert(field.values.end(), {color.r, color.g, color.b});
    }
    return {std::move(field)};
}

/// Maps, centres, checks and samples a clean mesh.
FittedKey fit_clean(const SurfaceMesh& mesh, Keeps keeps, const FitOptions& options,
                    const Progress& progress) {
    std::vector<StageTime> times;
    Stopwatch stopwatch(times);
    SphericalMap map = map_to_sphere(mesh, part_of(progress, 0, mapped_begins), keeps);
    stopwatch.lap("map to the sphere");
    center_map(mesh, map.points);
    if (const std::string fault = fault_of_map(mesh, map.points); !fault.empty())
        throw InputError(fmt::format("the centred map to the sphere is not valid: {}", fault));
    stopwatch.lap("centring");

    FittedKey key = fit_mapped(mesh, std::move(map.points), options, part_of(progress, mapped_begins, 1));
    key.report.map_method = map.method;
    key.report.map_keeps = keeps;
    key.report.times.insert(key.report.times.begin(), times.begin(), times.end());
    return key;
}

/// See FitReport::hausdorff_as_brought. \p key is of \p clean.
double distance_as_brought(const CleanMesh& clean, const FittedKey& key, const Progress& progress) {
    // Where nothing was changed that is the distance from the clean mesh, which has been measured.
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

}  // namespace

FittedKey fit_mapped(const SurfaceMesh& mesh, std::vector<glm::dvec3> points, const FitOptions& options,
                     const Progress& progress) {
    check_options(options);
    FittedKey key;
    FitReport& report = key.report;
    report.mesh_vertices = mesh.positions.size();
    report.mesh_triangles = mesh.triangles.size();
    Stopwatch stopwatch(report.times);
    rotate(points, rotation_to_surface(mesh, points));
    report.mean_cosine = mean_cosine(mesh, points);
    rotate(points, options.rotation);
    const MappedSurface mapped(mesh, points);
    stopwatch.lap("alignment");

    const SamplingOptions judged{.leaves = std::max(judged_leaves, options.roots.complex.triangle_count())};
    SampledSurface surface = leaves_over(mapped, options.roots, judged, part_of(progress, 0, 0.2));
    stopwatch.lap("sampling");
    report.at_20000_leaves = report.quality = measure_quality(mapped, surface, part_of(progress, 0.2, 0.5));
    stopwatch.lap("measuring");
    const std::string fault = fault_of_fit(report.at_20000_leaves, surface.leaves.size(), options.limits);
    if (!fault.empty()) throw InputError(fmt::format("no good key: {}", fault));

    if (options.tolerance) {
        std::tie(surface, report.quality) =
            sample_within(mapped, options.roots, *options.tolerance, part_of(progress, 0.5, 1));
        stopwatch.lap("sampling within the tolerance");
    } else if (options.leaves.value_or(judged.leaves) != judged.leaves) {
        surface =
            leaves_over(mapped, options.roots, {.leaves = *options.leaves}, part_of(progress, 0.5, 0.7));
        stopwatch.lap("sampling");
        report.quality = measure_quality(mapped, surface, part_of(progress, 0.7, 1));
        stopwatch.lap("measuring");
    }
    key.hierarchy = hierarchy_from_leaves(options.roots.complex, surface.leaves, surface.positions,
                                          color_fields(mesh, surface));
    return key;
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
    std::string unwanted;
    for (const std::string& change : unwanted_changes(clean.report, options.keep_largest, options.fill_holes))
        unwanted += (unwanted.empty() ? "" : "; ") + change;
    if (!unwanted.empty()) throw InputError(unwanted);

    std::vector<StageTime> times;
    Stopwatch stopwatch(times);
    FittedKey key;
    try {
        key = fit_clean(clean.mesh, Keeps::shapes, options, part_of(progress, 0, second_map_begins));
    } catch (const InputError&) {
        stopwatch.lap("first attempt");
        key = fit_clean(clean.mesh, Keeps::areas, options, part_of(progress, second_map_begins, 1));
    }
    key.report.hausdorff_as_brought = distance_as_brought(clean, key, {});
    key.report.clean_up = std::move(clean.report);
    key.mesh = std::move(clean.mesh);
    key.report.times.insert(key.report.times.begin(), times.begin(), times.end());
    return key;
}

}  // namespace interleaf
