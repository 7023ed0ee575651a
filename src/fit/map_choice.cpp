#include "fit/map_choice.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>

#include <fmt/core.h>

#include "fit/landmarks/pinned_map.h"
#include "fit/mesh/progress_meter.h"
#include "fit/mesh/surface_distance.h"
#include "fit/sampling/leaf_faults.h"
#include "fit/sphere_map/surface_approximation.h"
#include "fit/sphere_map/surface_refinement.h"
#include "hierarchy/error.h"

namespace interleaf {
namespace {

/// A mesh is refined if large triangles have this fraction of its area.
constexpr double large_part = 0.4;

/// If needles have this fraction of the area, the mesh's own map is tried only if the refined map is bad. A
/// long fan of needles takes longest to map, and gives the worst map.
constexpr double needle_part = 0.3;

/// A map is good enough if less than this fraction of its leaves needs smoothing.
constexpr double few_faulty = 0.05;

/// If more than this fraction of the leaves needs smoothing, smoothing takes seconds and improves little.
constexpr double many_faulty = 0.3;

/// If more than this fraction of the leaves of a mesh of large triangles needs smoothing, some keep small angles.
constexpr double badly_mended = 0.2;

/// A map is bad if more than this fraction of its leaves needs smoothing, or if its number of flipped leaves
/// is more than this multiple of the number for which it would be refused.
constexpr double max_faulty = 0.4;
constexpr double max_flipped_part = 3;

/// A key of which more than this fraction of the leaves is turned over stays refused, however it is smoothed.
constexpr double beyond_smoothing = 0.1;

/// A key that is this many times as far from the surface as an accepted one stays refused, however it is
/// smoothed.
constexpr double far_from_accepted = 2;

/// A key of a matched map is refused before it is smoothed if it has this multiple of the flipped leaves for which it
/// would be refused, or if this fraction of its leaves are needles where none is accepted. Of 28 such keys that were
/// smoothed nevertheless, one became acceptable.
constexpr double lost_flipped_part = 2;
constexpr double lost_needle_part = 0.01;

/// The refined mesh is as fine as this many equilateral triangles. A finer mesh gives better leaves. But on a
/// long thin body, the map of the finer mesh may shrink a limb; then a coarser mesh is tried.
constexpr double fine_triangles = 2000;
/// The same for meshes in which needles have more than needle_part.
constexpr double fine_triangles_of_needles = 3000;
constexpr double coarse_triangles = 1000;

/// Where a surface of needles is mapped, the refined mesh may be this far from the surface while it is mapped
/// (RefinementOptions::deviation), and this far, as a fraction of the box diagonal, afterwards. Keys are put onto
/// the surface itself.
constexpr double needle_deviation = 3e-4;
constexpr double closeness = 5e-5;

/// A key is poor if its least angle is smaller than this, in degrees, or if it has more than this fraction of
/// the flipped leaves for which it would be refused. A better key may be farther from the surface by this
/// factor.
constexpr double poor_angle = 5;
constexpr double poor_flipped_part = 0.25;
constexpr double farther_than_poor = 1.1;

/// A key is good if its least angle is at least this, in degrees, no leaf is flipped, and it is at most this fraction of
/// the box diagonal from the surface. The key of a refined mesh that is good is better than a nearer one with less than
/// this part of its least angle.
constexpr double good_angle = 10;
constexpr double good_distance = 1e-3;
constexpr double much_smaller = 0.5;

/// Before smoothing, a key is certainly poor beyond these limits. After smoothing, the other map is tried below this
/// angle, too.
constexpr double hopeless_angle = 1;
constexpr double hopeless_flipped_part = 1.5;

double faulty_part(const FoundMap& found) {
    return double(found.faulty) / double(found.surface.leaves.size());
}

/// As a fraction of the flipped leaves for which the map would be refused.
double flipped_part(const FoundMap& found, const FitLimits& limits) {
    return double(found.shapes.flipped_leaves) / (limits.flipped_part * double(found.surface.leaves.size()));
}

bool is_bad(const FoundMap& found, const FitLimits& limits) {
    return faulty_part(found) > max_faulty || flipped_part(found, limits) > max_flipped_part;
}

bool is_lost(const FoundMap& found) {
    return double(found.shapes.flipped_leaves) > beyond_smoothing * double(found.surface.leaves.size());
}

SampledSurface sampled(const AlignedMap& map, const SphereRoots& roots, const Progress& progress) {
    return sample_surface(map.mapped, roots, {.leaves = judged_leaves(roots)}, progress);
}

/// How far the vertices of the mapped mesh are from the key at most, as a fraction of the box diagonal. This takes a
/// tenth of the time of quality_of(), and is no more than the Hausdorff distance from the mapped mesh.
double distance_at_vertices(const AlignedMap& map, const SampledSurface& surface, const Progress& progress) {
    ProgressMeter meter(progress);
    meter.enter("measuring", 0);
    std::vector<Triangle> leaves;
    leaves.reserve(surface.leaves.size());
    for (const Leaf& leaf : surface.leaves) leaves.push_back(leaf.vertices);
    const std::vector<glm::dvec3> positions(surface.positions.begin(), surface.positions.end());
    const SurfaceDistance to_key(leaves, positions);
    Index nearest = no_index;
    double largest = 0;
    for (const glm::dvec3& position : map.mesh().positions) {
        largest = std::max(largest, to_key(position, nearest));
        meter.step();
    }
    return largest / box_diagonal(map.original);
}

/// Smooths and measures. The key of a bad map is not smoothed if it is so far from the surface that smoothing, which
/// moves vertices along the surface, cannot bring it near.
JudgedMap judged(FoundMap candidate, const SphereRoots& roots, const FitLimits& limits, Stopwatch& stopwatch,
                 const Progress& progress) {
    const auto is_far = [&] {
        const double distance =
            distance_at_vertices(*candidate.map, candidate.surface, part_of(progress, 0, 0.2));
        stopwatch.lap("measuring");
        return distance > far_from_accepted * limits.hausdorff;
    };
    if (candidate.map->has_large_triangles && is_bad(candidate, limits) && is_far()) {
        const FitQuality quality = quality_of(*candidate.map, candidate.surface, part_of(progress, 0.2, 1));
        stopwatch.lap("measuring");
        return {std::move(candidate.map), std::move(candidate.surface), quality, candidate.method,
                candidate.agreement};
    }
    smooth(*candidate.map, roots, candidate.surface, limits.hausdorff, part_of(progress, 0.2, 0.4));
    stopwatch.lap("smoothing");
    const FitQuality quality = quality_of(*candidate.map, candidate.surface, part_of(progress, 0.4, 1));
    stopwatch.lap("measuring");
    return {std::move(candidate.map), std::move(candidate.surface), quality, candidate.method,
            candidate.agreement};
}

/// Maps a mesh of the surface, centers the map unless it is pinned, checks it and samples it.
/// \param fine  the mesh to map; without triangles for the original mesh
/// \param is_approximate  whether \p fine only approximates the surface
FoundMap candidate(const SurfaceMesh& original, SurfaceMesh fine, bool is_approximate,
                   const MapChoiceOptions& options, Stopwatch& stopwatch, const Progress& progress) {
    const bool is_refined = !fine.triangles.empty();
    const SurfaceMesh& mesh = is_refined ? fine : original;
    const bool has_large_triangles = !is_only_mapped_as_it_is(original);
    const double crowded = is_refined || options.way.relaxes_crowded ? 0.01 : 0;
    FoundMap made;
    std::vector<glm::dvec3> points;
    std::optional<glm::dmat3> rotation;
    if (options.pins != nullptr) {
        PinnedMap map = map_to_pins(mesh, *options.pins, {.keeps = options.way.keeps, .crowded = crowded},
                                    part_of(progress, 0, 0.9));
        stopwatch.lap("map to the sphere");
        made.agreement = map.agreement;
        points = std::move(map.points);
    } else {
        SphericalMap map = map_to_sphere(mesh, part_of(progress, 0, 0.9), options.way.keeps, crowded);
        stopwatch.lap("map to the sphere");
        center_map(mesh, map.points);
        if (const std::string fault = fault_of_map(mesh, map.points); !fault.empty())
            throw InputError(fmt::format("the centered map to the sphere is not valid: {}", fault));
        stopwatch.lap("centering");
        made.method = map.method;
        points = std::move(map.points);
        rotation = options.rotation;
    }
    if (is_approximate) {
        ProgressMeter meter(progress);
        meter.enter("refining the mesh", 0.9);
        approximate_closely(original, fine, points, closeness * box_diagonal(original), meter);
        if (const std::string fault = fault_of_map(fine, points); !fault.empty())
            throw InputError(fmt::format("the refined map to the sphere is not valid: {}", fault));
        stopwatch.lap("refining");
    }
    made.map = std::make_shared<AlignedMap>(original, std::move(fine), std::move(points), is_approximate,
                                            rotation, has_large_triangles, options.landmarks);
    stopwatch.lap("alignment");
    made.surface = sampled(*made.map, options.roots, part_of(progress, 0.9, 1));
    made.faulty = count_faulty_leaves(made.map->mapped, made.surface);
    made.shapes = measure_shapes(made.map->mapped, made.surface);
    stopwatch.lap("sampling");
    return made;
}

/// The better of two maps, before smoothing.
bool is_better(const FoundMap& a, const FoundMap& b, const FitLimits& limits) {
    const double flipped = flipped_part(a, limits);
    const double flipped_of_b = flipped_part(b, limits);
    if (std::max(flipped, flipped_of_b) > max_flipped_part) return flipped < flipped_of_b;
    return a.faulty < b.faulty;
}

bool is_no_worse(const FitQuality& a, const FitQuality& b, double farther = 1) {
    return a.hausdorff <= farther * b.hausdorff && a.root_mean_square <= farther * b.root_mean_square &&
           a.min_angle >= b.min_angle && a.flipped_leaves <= b.flipped_leaves;
}

bool is_good(const FitQuality& quality) {
    return quality.min_angle >= good_angle && quality.flipped_leaves == 0 &&
           quality.hausdorff <= good_distance;
}

bool is_accepted(const JudgedMap& judged, const FitLimits& limits) {
    return fault_of_fit(judged.quality, judged.surface.leaves.size(), limits).empty();
}

/// Whether the key of a refined mesh is chosen over the key of the mesh as it is.
bool is_to_take(const JudgedMap& refined, const JudgedMap& as_it_is, const FitLimits& limits) {
    if (!is_accepted(refined, limits) || !is_accepted(as_it_is, limits)) return is_accepted(refined, limits);
    if (is_good(refined.quality) && as_it_is.quality.min_angle < much_smaller * refined.quality.min_angle)
        return true;
    const double flipped_limit = limits.flipped_part * double(as_it_is.surface.leaves.size());
    const bool is_poor = as_it_is.quality.min_angle < poor_angle ||
                         double(as_it_is.quality.flipped_leaves) > poor_flipped_part * flipped_limit;
    return is_no_worse(refined.quality, as_it_is.quality, is_poor ? farther_than_poor : 1);
}

/// Whether leaves of the key are needles, however it was made: the other map may give a better one.
bool is_hopeless(const FitQuality& smoothed) {
    return smoothed.min_angle < hopeless_angle;
}

/// Whether this choice is certain before the key of the mesh as it is has been smoothed. Smoothing brings no
/// key nearer to the surface. Where smoothing improves little, the figures are nearly final. Elsewhere the
/// choice is certain only if no leaf is left that smoothing might improve. (That many faulty leaves do not all get good
/// angles is experience.)
bool is_sure_to_take(const JudgedMap& refined, const FoundMap& as_it_is, const FitLimits& limits,
                     const Progress& progress) {
    const bool is_best = refined.quality.min_angle >= smoothed_angle && refined.quality.flipped_leaves == 0;
    if (is_best && is_good(refined.quality) && is_accepted(refined, limits) &&
        faulty_part(as_it_is) > badly_mended &&
        as_it_is.shapes.min_angle < much_smaller * refined.quality.min_angle)
        return true;
    const bool is_certainly_poor =
        as_it_is.shapes.min_angle < hopeless_angle || flipped_part(as_it_is, limits) > hopeless_flipped_part;
    const bool is_mended_little = faulty_part(as_it_is) > many_faulty;
    return (is_certainly_poor || is_mended_little || is_best) &&
           is_no_worse(refined.quality, quality_of(*as_it_is.map, as_it_is.surface, progress),
                       is_certainly_poor ? farther_than_poor : 1);
}

}  // namespace

bool is_only_mapped_as_it_is(const SurfaceMesh& mesh) {
    return triangle_shapes(mesh).large < large_part;
}

Index judged_leaves(const SphereRoots& roots) {
    return std::max<Index>(20000, roots.complex.triangle_count());
}

JudgedMap judge(std::shared_ptr<const AlignedMap> map, const SphereRoots& roots, const FitLimits& limits,
                double least_angle, Stopwatch& stopwatch, const Progress& progress) {
    FoundMap made;
    made.surface = sampled(*map, roots, part_of(progress, 0, 0.15));
    made.shapes = measure_shapes(map->mapped, made.surface);
    stopwatch.lap("sampling");
    made.map = std::move(map);
    const double needles =
        double(count_needles(made.surface, least_angle)) / double(made.surface.leaves.size());
    if (made.map->is_matched &&
        (flipped_part(made, limits) > lost_flipped_part || needles > lost_needle_part))
        return {std::move(made.map), std::move(made.surface), made.shapes};
    return judged(std::move(made), roots, limits, stopwatch, part_of(progress, 0.15, 1));
}

JudgedMap judge(ChosenMap chosen, const SphereRoots& roots, const FitLimits& limits, Stopwatch& stopwatch,
                const Progress& progress) {
    if (auto* const known = std::get_if<JudgedMap>(&chosen)) return std::move(*known);
    return judged(std::get<FoundMap>(std::move(chosen)), roots, limits, stopwatch, progress);
}

ChosenMap choose_map(const SurfaceMesh& mesh, const MapChoiceOptions& options, Stopwatch& stopwatch,
                     const Progress& progress) {
    const auto judged_in = [&](FoundMap made, double begin, double end) {
        return judged(std::move(made), options.roots, options.limits, stopwatch,
                      part_of(progress, begin, end));
    };
    if (is_only_mapped_as_it_is(mesh)) return candidate(mesh, {}, false, options, stopwatch, progress);

    const TriangleShapes shapes = triangle_shapes(mesh);
    std::string fault;
    const auto try_to_map = [&](SurfaceMesh fine, bool is_approximate, double begin,
                                double end) -> std::optional<FoundMap> {
        try {
            return candidate(mesh, std::move(fine), is_approximate, options, stopwatch,
                             part_of(progress, begin, end));
        } catch (const LandmarkError&) {
            throw;
        } catch (const InputError& error) {
            fault = error.what();
            return std::nullopt;
        }
    };
    std::optional<FoundMap> as_it_is;
    const bool has_needles = shapes.needles > needle_part;
    if (!has_needles) {
        as_it_is = try_to_map({}, false, 0, 0.2);
        if (as_it_is && faulty_part(*as_it_is) < few_faulty) return *std::move(as_it_is);
    }
    std::optional<FoundMap> refined;
    for (const auto& [triangles, begin, end] :
         {std::array{has_needles ? fine_triangles_of_needles : fine_triangles, 0.2, 0.45},
          std::array{coarse_triangles, 0.45, 0.6}}) {
        ProgressMeter meter(progress);
        meter.enter("refining the mesh", begin);
        SurfaceMesh fine =
            refine(mesh, {.triangles = triangles, .deviation = has_needles ? needle_deviation : 0}, meter);
        stopwatch.lap("refining");
        std::optional<FoundMap> made = try_to_map(std::move(fine), has_needles, begin, end);
        if (made && (!refined || is_better(*made, *refined, options.limits))) refined = std::move(made);
        if (refined && !is_bad(*refined, options.limits)) break;
    }
    if (has_needles && (!refined || is_bad(*refined, options.limits)))
        as_it_is = try_to_map({}, false, 0.6, 0.7);
    if (!as_it_is && !refined) throw InputError(fault);
    const auto better_of = [&](JudgedMap of_refined, JudgedMap of_original) {
        return is_to_take(of_refined, of_original, options.limits) ? std::move(of_refined)
                                                                   : std::move(of_original);
    };
    if (!as_it_is) {
        JudgedMap judged_refined = judged_in(*std::move(refined), 0.6, 0.8);
        if (!has_needles || !is_hopeless(judged_refined.quality)) return judged_refined;
        as_it_is = try_to_map({}, false, 0.8, 0.9);
        if (!as_it_is || (is_lost(*as_it_is) && is_accepted(judged_refined, options.limits)))
            return judged_refined;
        return better_of(std::move(judged_refined), judged_in(*std::move(as_it_is), 0.9, 1));
    }
    if (!refined || !is_better(*refined, *as_it_is, options.limits)) return *std::move(as_it_is);
    JudgedMap judged_refined = judged_in(*std::move(refined), 0.7, 0.8);
    if (is_bad(*as_it_is, options.limits) && !is_hopeless(judged_refined.quality)) return judged_refined;
    if (is_lost(*as_it_is) && is_accepted(judged_refined, options.limits)) return judged_refined;
    const bool is_sure =
        is_sure_to_take(judged_refined, *as_it_is, options.limits, part_of(progress, 0.8, 0.85));
    stopwatch.lap("choosing the map");
    if (is_sure) return judged_refined;
    return better_of(std::move(judged_refined), judged_in(*std::move(as_it_is), 0.85, 1));
}

}  // namespace interleaf
