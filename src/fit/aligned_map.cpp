#include "fit/aligned_map.h"

#include <cstddef>
#include <limits>
#include <utility>

#include "fit/sampling/leaf_smoothing.h"
#include "fit/sphere_map/alignment.h"

namespace interleaf {
namespace {

/// Maximum number of vertices, per leaf, that may look for better places on a refined mesh. On a body so long
/// that most leaves stay needles, further rounds take time and improve little.
constexpr double tries_per_leaf = 0.5;

}  // namespace

AlignedMap::AlignedMap(const SurfaceMesh& original_mesh, SurfaceMesh fine_mesh, std::vector<glm::dvec3> map,
                       const glm::dmat3& rotation)
    : original(original_mesh),
      fine(std::move(fine_mesh)),
      points(std::move(map)),
      mean_cosine(align()),
      mapped(mesh(), rotated(rotation)) {}

double AlignedMap::align() {
    rotate(points, rotation_to_surface(mesh(), points));
    return interleaf::mean_cosine(mesh(), points);
}

std::span<const glm::dvec3> AlignedMap::rotated(const glm::dmat3& rotation) {
    rotate(points, rotation);
    return points;
}

void smooth(const AlignedMap& map, const SphereRoots& roots, SampledSurface& surface,
            const Progress& progress) {
    smooth_leaves(map.mapped, roots.complex.vertex_count(), surface, progress,
                  map.is_refined() ? static_cast<std::size_t>(tries_per_leaf * double(surface.leaves.size()))
                                   : std::numeric_limits<std::size_t>::max());
}

FitQuality quality_of(const AlignedMap& map, const SampledSurface& surface, const Progress& progress) {
    return measure_quality(map.mapped, map.original, surface, progress);
}

}  // namespace interleaf
