#include "fit/fit_quality.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include <fmt/core.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "fit/mesh/parallel_work.h"
#include "fit/mesh/progress_meter.h"
#include "fit/mesh/space_triangle.h"
#include "fit/mesh/surface_distance.h"
#include "hierarchy/measure.h"

namespace interleaf {
namespace {

/// Number of places on each mesh, besides its vertices, if the places are spread evenly.
constexpr double places_per_mesh = 100000;

/// Maximum number of parts per edge in the grid over one triangle.
constexpr double max_parts = 64;

/// A triangle more than this many times as long as high is a needle. A grid over a needle would be as fine
/// across as along. So there are strips across a needle that would have at least this many parts: as many
/// strips, and more as long as all needles together have about as many strips as there are places.
constexpr double needle = 10;
constexpr double min_parts_of_needle = 8;

TriangleCorners corners_of(const MeshView& flat, const Triangle& triangle) {
    const auto& [a, b, c] = triangle;
    return {flat.positions[a], flat.positions[b], flat.positions[c]};
}

double parts_of(const LongTriangle& along, double spacing) {
    return spacing > 0 ? std::clamp(std::ceil(along.length() / spacing), 1.0, max_parts) : 1;
}

bool is_needle(const LongTriangle& along, double doubled_area, double spacing) {
    return along.length() * along.length() > needle * doubled_area &&
           parts_of(along, spacing) >= min_parts_of_needle;
}

/// The mean over a triangle of the squares that \p measure(const glm::dvec3& place) returns.
/// \param strips   across the longest side
/// \param spacing  of the places in a strip
template <typename Measure>
double mean_over_strips(const LongTriangle& along, double strips, double spacing, Measure measure) {
    double sum = 0;
    double widths = 0;
    for (double strip = 0; strip < strips; ++strip) {
        const double part = (strip + 0.5) / strips;
        const glm::dvec3 begin = along.on_side(part);
        const glm::dvec3 across = along.on_other_sides(part) - begin;
        const double width = glm::length(across);
        const double places_across = std::max(std::ceil(width / spacing), 1.0);
        double sum_across = 0;
        for (double place = 0; place < places_across; ++place)
            sum_across += measure(begin + (place + 0.5) / places_across * across);
        sum += width * sum_across / places_across;
        widths += width;
    }
    return widths > 0 ? sum / widths : 0;
}

struct Distances {
    double largest = 0;
    double mean_square = 0;  ///< weighted by area
};

/// Distances of the vertices of \p from, and of grids over its triangles, from a mesh.
Distances distances(const MeshView& from, const SurfaceDistance& distance, const Progress& progress) {
    double area = 0;
    for (const Triangle& triangle : from.triangles) area += doubled_area(corners_of(from, triangle)) / 2;
    // A grid of right triangles with this side has about that many places.
    const double spacing = std::sqrt(area / places_per_mesh);
    double length_of_needles = 0;
    for (const Triangle& triangle : from.triangles) {
        const TriangleCorners corners = corners_of(from, triangle);
        const LongTriangle along(corners);
        if (is_needle(along, doubled_area(corners), spacing)) length_of_needles += along.length();
    }
    const double strip_length = std::max(spacing, length_of_needles / places_per_mesh);

    Distances found;
    ProgressMeter meter(progress);
    meter.enter("measuring", 0);
    std::size_t count = 0;
    Index nearest = no_index;
    const auto measure = [&](const glm::dvec3& place) {
        meter.set_part(std::min(1.0, double(++count) / (places_per_mesh + double(from.positions.size()))));
        meter.step();
        const double here = distance(place, nearest);
        found.largest = std::max(found.largest, here);
        return here * here;
    };
    for (const Triangle& triangle : from.triangles) {
        const TriangleCorners corners = corners_of(from, triangle);
        const LongTriangle along(corners);
        const double parts = parts_of(along, spacing);
        const double doubled = doubled_area(corners);
        if (is_needle(along, doubled, spacing)) {
            const double strips = std::max(parts, std::ceil(along.length() / strip_length));
            found.mean_square += mean_over_strips(along, strips, spacing, measure) * doubled / 2 / area;
            continue;
        }
        const glm::dvec3& a = corners[0];
        const glm::dvec3 along_b = corners[1] - a;
        const glm::dvec3 along_c = corners[2] - a;
        // The centers of those grid triangles that are oriented like the whole: each represents an equal part
        // of it.
        double sum = 0;
        double terms = 0;
        for (double row = 0; row < parts; ++row)
            for (double column = 0; column + row < parts; ++column, ++terms)
                sum += measure(a + (row + 1.0 / 3) / parts * along_b + (column + 1.0 / 3) / parts * along_c);
        if (area > 0) found.mean_square += sum / terms * doubled / 2 / area;
    }
    for (const glm::dvec3& vertex : from.positions) measure(vertex);
    return found;
}

/// A mesh, and what measures the distance from it.
struct MeasuredMesh {
    MeshView mesh;
    const SurfaceDistance& distance;
};

/// Distances of \p a from \p b, and of \p b from \p a on another thread.
std::array<Distances, 2> distances_both_ways(const MeasuredMesh& a, const MeasuredMesh& b,
                                             const Progress& progress) {
    ParallelWork<Distances> back(
        [&](const Progress& is_wanted) { return distances(b.mesh, a.distance, is_wanted); });
    const Distances there = distances(a.mesh, b.distance, progress);
    return {there, back.wait("measuring", part_of(progress, 1, 1))};
}

std::vector<Triangle> triangles_of(const SampledSurface& surface) {
    std::vector<Triangle> triangles;
    triangles.reserve(surface.leaves.size());
    for (const Leaf& leaf : surface.leaves) triangles.push_back(leaf.vertices);
    return triangles;
}

}  // namespace

double hausdorff_distance(const MeshView& a, const MeshView& b, const Progress& progress) {
    const auto [there, back] = distances_both_ways({a, SurfaceDistance(a.triangles, a.positions)},
                                                   {b, SurfaceDistance(b.triangles, b.positions)}, progress);
    return std::max(there.largest, back.largest);
}

FitQuality measure_shapes(const MappedSurface& mapped, const SampledSurface& surface) {
    const std::vector<Triangle> triangles = triangles_of(surface);
    FitQuality quality;
    quality.min_angle = measure(triangles, surface.positions).min_angle;
    quality.flipped_leaves = static_cast<std::size_t>(std::ranges::count_if(
        triangles, [&](const Triangle& leaf) { return is_turned_over(leaf, surface, mapped); }));
    quality.euler = euler_number(triangles);
    return quality;
}

FitQuality measure_quality(const MappedSurface& mapped, const SampledSurface& surface,
                           const Progress& progress) {
    return measure_quality(mapped, mapped.mesh, surface, progress);
}

FitQuality measure_quality(const MappedSurface& mapped, const SurfaceMesh& original,
                           const SampledSurface& surface, const Progress& progress) {
    const std::vector<Triangle> triangles = triangles_of(surface);
    const std::vector<glm::dvec3> positions(surface.positions.begin(), surface.positions.end());
    const MeshView key{triangles, positions};
    const MeshView flat_original{original.triangles, original.positions};

    std::optional<SurfaceDistance> from_original;
    if (&original != &mapped.mesh) from_original.emplace(original.triangles, original.positions);

    const double diagonal = box_diagonal(original);
    const auto [to_key, to_surface] =
        distances_both_ways({flat_original, from_original ? *from_original : mapped.distance},
                            {key, SurfaceDistance(triangles, positions)}, progress);
    FitQuality quality = measure_shapes(mapped, surface);
    quality.hausdorff = std::max(to_key.largest, to_surface.largest) / diagonal;
    quality.root_mean_square = std::sqrt((to_key.mean_square + to_surface.mean_square) / 2) / diagonal;
    return quality;
}

std::string fault_of_fit(const FitQuality& quality, std::size_t leaves, const FitLimits& limits) {
    if (!(quality.hausdorff < limits.hausdorff))
        return fmt::format(
            "{:.3g} % of the box diagonal from the surface at {} leaves, expected less than {:.3g} %",
            100 * quality.hausdorff, leaves, 100 * limits.hausdorff);
    const double flipped = double(quality.flipped_leaves) / double(leaves);
    if (!(flipped < limits.flipped_part))
        return fmt::format("{:.3g} % of {} leaves are turned over, expected less than {:.3g} %",
                           100 * flipped, leaves, 100 * limits.flipped_part);
    if (quality.euler != 2) return fmt::format("Euler number {}, expected 2", quality.euler);
    return {};
}

}  // namespace interleaf
