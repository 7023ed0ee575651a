#include "fit/fit.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstddef>
#include <limits>
#include <memory>
#include <optional>
#include <tuple>
#include <utility>

#include <fmt/core.h>
#include <glm/common.hpp>

#include "fit/mesh/progress_meter.h"
#include "fit/sampling/leaf_smoothing.h"
#include "fit/sampling/surface_sampling.h"
#include "fit/sphere_map/alignment.h"
#include "fit/sphere_map/spherical_map.h"
#include "fit/sphere_map/surface_refinement.h"
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
constexpr double mapped_begins = 0.75;

/// A map needs no better one when less than this part of its leaves is to be smoothed.
constexpr double few_faulty = 0.05;

/// Where more than this part is to be smoothed, smoothing takes seconds and mends little.
constexpr double many_faulty = 0.4;

/// A mesh is refined where large triangles have this part of its area,
constexpr double large_part = 0.4;

/// and it is refined first, before the mesh is tried as it is, where needles have this part.
constexpr double needle_part = 0.5;

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

/// A surface with its map to the sphere, turned as it is to be sampled.
struct Mapping {
    /// \param original  outlives this
    /// \param fine      a finer mesh of it, that \p map belongs to; without triangles where the map is of the
    ///                  original
    Mapping(const SurfaceMesh& original_mesh, SurfaceMesh fine_mesh, std::vector<glm::dvec3> map,
            const glm::dmat3& rotation)
        : original(original_mesh),
          fine(std::move(fine_mesh)),
          points(std::move(map)),
          mean_cosine(align(mesh(), points)),
          mapped(mesh(), rotated(rotation)) {}
    Mapping(const Mapping&) = delete;
    Mapping& operator=(const Mapping&) = delete;

    bool is_refined() const { return !fine.triangles.empty(); }
    const SurfaceMesh& mesh() const { return is_refined() ? fine : original; }

    const SurfaceMesh& original;
    const SurfaceMesh fine;
    std::vector<glm::dvec3> points;
    const double mean_cosine;
    const MappedSurface mapped;

  private:
    static double align(const SurfaceMesh& mesh, std::vector<glm::dvec3>& points) {
        rotate(points, rotation_to_surface(mesh, points));
        return interleaf::mean_cosine(mesh, points);
    }
    std::span<const glm::dvec3> rotated(const glm::dmat3& rotation) {
        rotate(points, rotation);
        return points;
    }
};

/// Vertices that may look for better places on a refined mesh, for each leaf: on a body so long that most
/// leaves stay needles, further rounds take their time and mend little.
constexpr std::size_t tries_per_leaf = 1;

void smooth(const Mapping& mapping, const SphereRoots& roots, SampledSurface& surface,
            const Progress& progress) {
    smooth_leaves(mapping.mapped, roots.complex.vertex_count(), surface, progress,
                  mapping.is_refined() ? tries_per_leaf * surface.leaves.size()
                                       : std::numeric_limits<std::size_t>::max());
}

/// Samples and smooths.
SampledSurface leaves_over(const Mapping& mapping, const SphereRoots& roots, const SamplingOptions& options,
                           const Progress& progress) {
    SampledSurface surface = sample_surface(mapping.mapped, roots, options, part_of(progress, 0, 0.5));
    smooth(mapping, roots, surface, part_of(progress, 0.5, 1));
    return surface;
}

/// Samples until the measured distance is within \p tolerance, a part of the box diagonal.
std::pair<SampledSurface, FitQuality> sample_within(const Mapping& mapping, const SphereRoots& roots,
                                                    double tolerance, const Progress& progress) {
    const double diagonal = box_diagonal(mapping.original);
    double inside = tolerance * (1 - sampling_margin);
    for (int tries = 1;; ++tries) {
        SampledSurface surface =
            leaves_over(mapping, roots, {.leaves = most_leaves, .tolerance = inside * diagonal}, progress);
        if (surface.leaves.size() + 100 > most_leaves)
            throw InputError(
                fmt::format("a tolerance of {} needs more than {} leaves", tolerance, most_leaves));
        const FitQuality quality = measure_quality(mapping.mapped, mapping.original, surface, progress);
        if (quality.hausdorff <= tolerance) return {std::move(surface), quality};
        if (tries == most_tries)
            throw InputError(
                fmt::format("a tolerance of {} cannot be reached: {:.3g} is what {} leaves come to",
                            tolerance, quality.hausdorff, surface.leaves.size()));
        inside *= std::max(0.25, (1 - sampling_margin) * tolerance / quality.hausdorff);
    }
}

/// The colour of the triangle mesh at a place on it.
glm::vec3 color_at(const SurfaceMesh& mesh, const SurfaceDistance& distance, const glm::dvec3& place,
                   Index& nearest) {
    distance(place, nearest);
    const auto& [a, b, c] = mesh.triangles[nearest];
    const glm::dvec3 ab = mesh.positions[b] - mesh.positions[a];
    const glm::dvec3 ac = mesh.positions[c] - mesh.positions[a];
    const glm::dvec3 normal = glm::cross(ab, ac);
    const double squared = glm::dot(normal, normal);
    const glm::dvec3 from_a = place - mesh.positions[a];
    const double at_b = squared > 0 ? glm::dot(glm::cross(from_a, ac), normal) / squared : 0;
    const double at_c = squared > 0 ? glm::dot(glm::cross(ab, from_a), normal) / squared : 0;
    return static_cast<float>(1 - at_b - at_c) * mesh.colors[a] + static_cast<float>(at_b) * mesh.colors[b] +
           static_cast<float>(at_c) * mesh.colors[c];
}

/// The colours of the mesh at the sampled points, as the field "color"; none for a mesh without.
std::vector<Field> color_fields(const Mapping& mapping, const SampledSurface& surface) {
    const SurfaceMesh& mesh = mapping.original;
    if (mesh.colors.empty()) return {};
    Field field{"color", FieldKind::color, {}};
    field.values.reserve(3 * surface.mesh_points.size());
    const auto add = [&](const glm::vec3& value) {
        const glm::vec3 color = glm::clamp(value, 0.0F, 1.0F);
        field.values.insert(field.values.end(), {color.r, color.g, color.b});
    };
    if (mapping.is_refined()) {
        // Edges of the mesh are flipped in the refined one: between its vertices colours would differ.
        const SurfaceDistance distance(mesh.triangles, mesh.positions);
        Index nearest = no_index;
        for (const MeshPoint& point : surface.mesh_points)
            add(color_at(mesh, distance, mapping.mapped.position(point), nearest));
    } else {
        for (const MeshPoint& point : surface.mesh_points)
            add(point.of(std::span(mesh.triangles), std::span(mesh.colors)));
    }
    return {std::move(field)};
}

SamplingOptions judged_sampling(const FitOptions& options) {
    return {.leaves = std::max(judged_leaves, options.roots.complex.triangle_count())};
}

/// Smooths and judges a sampled map, samples as it is asked for, and makes the key.
/// \param surface  sampled with judged_sampling(), not smoothed
FittedKey key_of(const Mapping& mapping, SampledSurface surface, const FitOptions& options,
                 const Progress& progress) {
    FittedKey key;
    FitReport& report = key.report;
    report.mesh_vertices = mapping.original.positions.size();
    report.mesh_triangles = mapping.original.triangles.size();
    report.mean_cosine = mapping.mean_cosine;
    Stopwatch stopwatch(report.times);
    smooth(mapping, options.roots, surface, part_of(progress, 0, 0.15));
    stopwatch.lap("smoothing");
    const auto measured = [&](double begin, double end) {
        return measure_quality(mapping.mapped, mapping.original, surface, part_of(progress, begin, end));
    };
    report.at_20000_leaves = report.quality = measured(0.15, 0.5);
    stopwatch.lap("measuring");
    const std::string fault = fault_of_fit(report.at_20000_leaves, surface.leaves.size(), options.limits);
    if (!fault.empty()) throw InputError(fmt::format("no good key: {}", fault));

    const Index judged = judged_sampling(options).leaves;
    if (options.tolerance) {
        std::tie(surface, report.quality) =
            sample_within(mapping, options.roots, *options.tolerance, part_of(progress, 0.5, 1));
        stopwatch.lap("sampling within the tolerance");
    } else if (options.leaves.value_or(judged) != judged) {
        surface =
            leaves_over(mapping, options.roots, {.leaves = *options.leaves}, part_of(progress, 0.5, 0.7));
        stopwatch.lap("sampling");
        report.quality = measured(0.7, 1);
        stopwatch.lap("measuring");
    }
    key.hierarchy = hierarchy_from_leaves(options.roots.complex, surface.leaves, surface.positions,
                                          color_fields(mapping, surface));
    return key;
}

/// A map that is tried, with what may come of it.
struct Attempt {
    std::unique_ptr<const Mapping> mapping;
    SampledSurface surface;  ///< with judged_sampling(), not smoothed
    std::size_t faulty = 0;  ///< leaves that are to be smoothed
    MapMethod method = MapMethod::progressive;

    double faulty_part() const { return double(faulty) / double(surface.leaves.size()); }
};

/// Maps a clean mesh, or a finer one of the same surface, centres, checks and samples.
Attempt attempt(const SurfaceMesh& original, SurfaceMesh fine, Keeps keeps, const FitOptions& options,
                Stopwatch& stopwatch, const Progress& progress) {
    const bool is_refined = !fine.triangles.empty();
    const SurfaceMesh& mesh = is_refined ? fine : original;
    constexpr double crowded = 0.01;
    SphericalMap map = map_to_sphere(mesh, part_of(progress, 0, 0.9), keeps, is_refined ? crowded : 0);
    stopwatch.lap("map to the sphere");
    center_map(mesh, map.points);
    if (const std::string fault = fault_of_map(mesh, map.points); !fault.empty())
        throw InputError(fmt::format("the centred map to the sphere is not valid: {}", fault));
    stopwatch.lap("centring");
    Attempt made;
    made.method = map.method;
    made.mapping =
        std::make_unique<Mapping>(original, std::move(fine), std::move(map.points), options.rotation);
    stopwatch.lap("alignment");
    made.surface = sample_surface(made.mapping->mapped, options.roots, judged_sampling(options),
                                  part_of(progress, 0.9, 1));
    made.faulty = count_faulty_leaves(made.mapping->mapped, made.surface);
    stopwatch.lap("sampling");
    return made;
}

/// Whether the map of the refined mesh makes the better key.
bool is_better(const Attempt& refined, const Attempt& as_it_is, const Progress& progress) {
    if (refined.faulty >= as_it_is.faulty) return false;
    if (as_it_is.faulty_part() > many_faulty) return true;
    const auto quality = [&](const Attempt& attempt, double begin, double end) {
        return measure_quality(attempt.mapping->mapped, attempt.mapping->original, attempt.surface,
                               part_of(progress, begin, end));
    };
    const FitQuality of_refined = quality(refined, 0, 0.5);
    const FitQuality as_it_is_now = quality(as_it_is, 0.5, 1);
    const bool is_turned_less = of_refined.flipped_leaves < as_it_is_now.flipped_leaves;
    const bool is_refusal_near = double(as_it_is_now.flipped_leaves) >
                                 FitLimits{}.flipped_part * double(as_it_is.surface.leaves.size());
    return of_refined.hausdorff <= as_it_is_now.hausdorff || (is_refusal_near && is_turned_less);
}

/// The better of the maps of a mesh as it is and refined. A map that fails is none.
Attempt better_attempt(const SurfaceMesh& mesh, Keeps keeps, const FitOptions& options, Stopwatch& stopwatch,
                       const Progress& progress) {
    const TriangleShapes shapes = triangle_shapes(mesh);
    if (shapes.large < large_part) return attempt(mesh, {}, keeps, options, stopwatch, progress);

    std::string fault;
    const auto try_to_map = [&](SurfaceMesh fine, double begin, double end) -> std::optional<Attempt> {
        try {
            return attempt(mesh, std::move(fine), keeps, options, stopwatch, part_of(progress, begin, end));
        } catch (const InputError& error) {
            fault = error.what();
            return std::nullopt;
        }
    };
    // Long fans of needles take the longest to map, to the worst maps.
    const bool refined_first = shapes.needles > needle_part;
    std::optional<Attempt> as_it_is;
    if (!refined_first) {
        as_it_is = try_to_map({}, 0, 0.25);
        if (as_it_is && as_it_is->faulty_part() < few_faulty) return *std::move(as_it_is);
    }
    std::optional<Attempt> refined;
    // A finer mesh makes better leaves, but on a long thin body its map may be the one that shrinks a limb.
    for (const auto& [triangles, begin, end] :
         {std::array{3000.0, 0.25, 0.55}, std::array{1000.0, 0.55, 0.7}}) {
        ProgressMeter meter(progress);
        meter.enter("refining the mesh", begin);
        SurfaceMesh fine = refine(mesh, {.triangles = triangles}, meter);
        stopwatch.lap("refining");
        std::optional<Attempt> made = try_to_map(std::move(fine), begin, end);
        if (made && (!refined || made->faulty < refined->faulty)) refined = std::move(made);
        if (refined && refined->faulty_part() <= many_faulty) break;
    }
    if (refined_first && (!refined || refined->faulty_part() > many_faulty))
        as_it_is = try_to_map({}, 0.7, 0.9);
    if (!as_it_is && !refined) throw InputError(fault);
    if (!as_it_is) return *std::move(refined);
    if (!refined) return *std::move(as_it_is);
    Attempt chosen = is_better(*refined, *as_it_is, part_of(progress, 0.9, 1)) ? *std::move(refined)
                                                                               : *std::move(as_it_is);
    stopwatch.lap("choosing the map");
    return chosen;
}

/// Maps, centres, checks and samples a clean mesh.
FittedKey fit_clean(const SurfaceMesh& mesh, Keeps keeps, const FitOptions& options,
                    const Progress& progress) {
    std::vector<StageTime> times;
    Stopwatch stopwatch(times);
    Attempt chosen = better_attempt(mesh, keeps, options, stopwatch, part_of(progress, 0, mapped_begins));
    FittedKey key =
        key_of(*chosen.mapping, std::move(chosen.surface), options, part_of(progress, mapped_begins, 1));
    key.report.map_method = chosen.method;
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
    std::vector<StageTime> times;
    Stopwatch stopwatch(times);
    const Mapping mapping(mesh, {}, std::move(points), options.rotation);
    stopwatch.lap("alignment");
    SampledSurface surface =
        sample_surface(mapping.mapped, options.roots, judged_sampling(options), part_of(progress, 0, 0.1));
    stopwatch.lap("sampling");
    FittedKey key = key_of(mapping, std::move(surface), options, part_of(progress, 0.1, 1));
    key.report.times.insert(key.report.times.begin(), times.begin(), times.end());
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
