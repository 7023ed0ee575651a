// Any closed surface without handles becomes a key: clean-up, map to the sphere, alignment, sampling over
// root triangles, acceptance.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include "fit/clean_up/clean_up.h"
#include "fit/fit_quality.h"
#include "fit/mesh/progress.h"
#include "fit/mesh/stopwatch.h"
#include "fit/mesh/surface_mesh.h"
#include "fit/sphere_map/sphere_roots.h"
#include "fit/sphere_map/spherical_map.h"
#include "hierarchy/hierarchy.h"

namespace interleaf {

struct FitOptions {
    /// Roots over the sphere; keys over the same ones can be morphed.
    SphereRoots roots = project_to_sphere(cube());

    std::optional<Index> leaves{};  ///< at most this many, at least the roots; 20,000 when nothing is named

    /// Instead of leaves: the largest distance between key and surface, as a fraction of the box diagonal; at
    /// least 1e-5.
    std::optional<double> tolerance{};

    /// Turns the surface before it is looked at which of its parts goes where on the sphere; positions stay.
    glm::dmat3 rotation{1};

    FitLimits limits{};

    bool keep_largest = false;  ///< of several parts, however much of the area is lost
    bool fill_holes = false;    ///< however much area that adds
};

struct FitReport {
    CleanUpReport clean_up;
    std::size_t mesh_vertices = 0;  ///< of the surface once clean
    std::size_t mesh_triangles = 0;
    MapMethod map_method = MapMethod::progressive;
    Keeps map_keeps = Keeps::shapes;
    double mean_cosine = 0;      ///< of directions on the sphere against directions in space (alignment.h)
    FitQuality at_20000_leaves;  ///< what acceptance was judged by
    FitQuality quality;          ///< of the key
    /// The largest distance between the key and the mesh as it was brought, with all its parts and holes, as
    /// a part of the diagonal of its box.
    double hausdorff_as_brought = 0;

    std::vector<StageTime> times;
};

struct FittedKey {
    Hierarchy hierarchy;  ///< with the field "color" where the mesh has colors
    FitReport report;
    SurfaceMesh mesh;  ///< what the key stands for: the mesh once clean; from fit_mapped() none
};

/// The way to map, in words for people and reports.
std::string_view name_of(MapMethod method);
std::string_view name_of(Keeps keeps);

/// A map that keeps shapes is tried first, and where that gives no good key, one that keeps areas.
/// \throw InputError  saying what is wrong with the mesh, what cleaning up would change unasked, or why no
/// key stands for it well enough \throw UsageError  when leaves and tolerance are both named, or one is out
/// of its range \throw Cancelled   when progress says so
FittedKey fit(SurfaceMesh mesh, const FitOptions& options, const Progress& progress = {});

/// The part of fit() behind the clean-up.
FittedKey fit(CleanMesh clean, const FitOptions& options, const Progress& progress = {});

/// The part of fit() behind the map to the sphere: aligns \p points, samples, and accepts or refuses.
/// \p mesh is clean, \p points its map, one a vertex.
FittedKey fit_mapped(const SurfaceMesh& mesh, std::vector<glm::dvec3> points, const FitOptions& options,
                     const Progress& progress = {});

}  // namespace interleaf
