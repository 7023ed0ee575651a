// A surface with its map to the sphere, turned into the position in which it is sampled.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include "fit/fit_quality.h"
#include "fit/mesh/surface_mesh.h"
#include "fit/sampling/mapped_surface.h"
#include "fit/sampling/surface_sampling.h"
#include "fit/sphere_map/sphere_roots.h"
#include "hierarchy/progress.h"

namespace interleaf {

struct AlignedMap {
    /// Aligns the map to space (alignment.h), and then rotates it.
    /// \param original_mesh  must outlive this object
    /// \param fine_mesh      a finer mesh of the same surface (surface_refinement.h), to which \p map
    ///                       belongs; without triangles if \p map belongs to \p original_mesh
    /// \param map            points of the unit sphere, one per vertex, one to one
    /// \param rotation       applied after the alignment; none for a map that is in position already
    /// \param is_approximate         whether \p fine_mesh only approximates the surface
    ///                               (surface_approximation.h); keys are then put onto the surface at the end
    /// \param is_of_large_triangles  whether \p original_mesh is one for which a finer mesh is tried
    /// \param landmarks      see MappedSurface
    AlignedMap(const SurfaceMesh& original_mesh, SurfaceMesh fine_mesh, std::vector<glm::dvec3> map,
               bool is_approximate, const std::optional<glm::dmat3>& rotation, bool is_of_large_triangles,
               std::span<const glm::dvec3> landmarks = {});

    /// A map that is in its final position, because it is matched to another body's map.
    AlignedMap(const SurfaceMesh& original_mesh, SurfaceMesh fine_mesh, std::vector<glm::dvec3> map,
               bool is_approximate, std::span<const glm::dvec3> landmarks = {});
    AlignedMap(const AlignedMap&) = delete;
    AlignedMap& operator=(const AlignedMap&) = delete;

    bool is_refined() const { return !fine.triangles.empty(); }
    const SurfaceMesh& mesh() const { return is_refined() ? fine : original; }

    const SurfaceMesh& original;
    const bool has_large_triangles;
    const bool is_matched;
    const bool is_approximate;
    const SurfaceMesh fine;
    std::vector<glm::dvec3> points;
    const double mean_cosine;  ///< of the aligned map, before the rotation
    const MappedSurface mapped;

  private:
    double align(bool is_turned);
    std::span<const glm::dvec3> rotated(const std::optional<glm::dmat3>& rotation);
};

/// Calls smooth_leaves(). Limits its work on a refined mesh, where the map is matched, and elsewhere if many of the
/// leaves are faulty.
/// \param accepted_distance  as a fraction of the box diagonal; for a better angle, no leaf goes nearly as far as this,
///                           unless the map is matched
void smooth(const AlignedMap& map, const SphereRoots& roots, SampledSurface& surface,
            double accepted_distance, const Progress& progress);

/// Calls measure_quality() against the original mesh.
FitQuality quality_of(const AlignedMap& map, const SampledSurface& surface, const Progress& progress);

}  // namespace interleaf
