#include "fit/fit_quality.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/core.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "fit/mesh/progress_meter.h"
#include "fit/mesh/surface_distance.h"
#include "hierarchy/measure.h"

namespace interleaf {
namespace {

/// Number of places on each mesh, besides its vertices, if the places are spread evenly.
constexpr double places = 100000;

/// Maximum number of parts per edge in the grid over one triangle.
constexpr double max_parts = 64;

glm::dvec3 doubled_area(const MeshView& flat, const Triangle& triangle) {
    const glm::dvec3& a = flat.positions[triangle[0]];
    return glm::cross(flat.positions[triangle[1]] - a, flat.positions[triangle[2]] - a);
}

struct Distances {
    double largest = 0;
    double mean_square = 0;  ///< weighted by area
};

/// Distances of the vertices of \p from, and of grids over its triangles, from a mesh.
Distances distances(const MeshView& from, const SurfaceDistance& distance, const Progress& progress,
                    double begin) {
    double area = 0;
    for (const Triangle& triangle : from.triangles) area += glm::length(doubled_area(from, triangle)) / 2;
    // A grid of right triangles with this side has about that many places.
    const double spacing = std::sqrt(area / places);

    Distances found;
    ProgressMeter meter(progress);
    meter.enter("measuring", begin);
    std::size_t count = 0;
    Index nearest = no_index;
    const auto measure = [&](const glm::dvec3& place) {
        meter.set_part(begin + std::min(0.5, double(++count) / (places + double(from.positions.size())) / 2));
        meter.step();
        const double here = distance(place, nearest);
        found.largest = std::max(found.largest, here);
        return here * here;
    };
    for (const Triangle& triangle : from.triangles) {
        const glm::dvec3& a = from.positions[triangle[0]];
        const glm::dvec3 along_b = from.positions[triangle[1]] - a;
        const glm::dvec3 along_c = from.positions[triangle[2]] - a;
        const double longest =
            std::max({glm::length(along_b), glm::length(along_c), glm::length(along_c - along_b)});
        const double parts = spacing > 0 ? std::clamp(std::ceil(longest / spacing), 1.0, max_parts) : 1;
        // The centers of those grid triangles that are oriented like the whole: each represents an equal part
        // of it.
        double sum = 0;
        double terms = 0;
        for (double row = 0; row < parts; ++row)
            for (double column = 0; column + row < parts; ++column, ++terms)
                sum += measure(a + (row + 1.0 / 3) / parts * along_b + (column + 1.0 / 3) / parts * along_c);
        if (area > 0) found.mean_square += sum / terms * glm::length(doubled_area(from, triangle)) / 2 / area;
    }
    for (const glm::dvec3& vertex : from.positions) measure(vertex);
    return found;
}

std::vector<Triangle> triangles_of(const SampledSurface& surface) {
    std::vector<Triangle> triangles;
    triangles.reserve(surface.leaves.size());
    for (const Leaf& leaf : surface.leaves) triangles.push_back(leaf.vertices);
    return triangles;
}

}  // namespace

double box_diagonal(const SurfaceMesh& mesh) {
    SpaceBox box{mesh.positions[0], mesh.positions[0]};
    for (const glm::dvec3& position : mesh.positions)
        box = {glm::min(box.min, position), glm::max(box.max, position)};
    return glm::distance(box.min, box.max);
}

double hausdorff_distance(const MeshView& a, const MeshView& b, const Progress& progress) {
    const Distances there = distances(a, SurfaceDistance(b.triangles, b.positions), progress, 0);
    const Distances back = distances(b, SurfaceDistance(a.triangles, a.positions), progress, 0.5);
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
    const Distances to_key = distances(flat_original, SurfaceDistance(triangles, positions), progress, 0);
    const Distances to_surface =
        distances(key, from_original ? *from_original : mapped.distance, progress, 0.5);
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
