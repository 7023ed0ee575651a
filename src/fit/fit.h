// Turns any closed surface without handles into a key: clean-up, map to the sphere, alignment, sampling over
// root triangles, and acceptance.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include "fit/clean_up/clean_up.h"
#include "fit/correspondence/match.h"
#include "fit/fit_quality.h"
#include "fit/landmarks/landmark_report.h"
#include "fit/mesh/stopwatch.h"
#include "fit/mesh/surface_mesh.h"
#include "fit/sphere_map/sphere_roots.h"
#include "fit/sphere_map/spherical_map.h"
#include "hierarchy/cube.h"
#include "hierarchy/hierarchy.h"
#include "hierarchy/landmark.h"
#include "hierarchy/progress.h"

namespace interleaf {

struct FitOptions {
    /// Roots over the sphere. Keys over the same roots can be morphed.
    SphereRoots roots = project_to_sphere(cube());

    std::optional<Index> leaves{};  ///< maximum, at least the roots; 20,000 by default

    /// Instead of leaves: the largest distance between key and surface, as a fraction of the box diagonal; at
    /// least 1e-5.
    std::optional<double> tolerance{};

    /// Turns the surface before its parts are assigned to places on the sphere. Positions do not change.
    glm::dmat3 rotation{1};

    FitLimits limits{};

    /// The body whose map this mesh's map is matched to; must outlive the fit. No other body if null.
    const MatchedBody* model = nullptr;
    MatchOptions matching{};

    /// Points of the surface or near it. Either all have directions, and the map brings them exactly there; then
    /// \a rotation turns only the body that is matched to a model. Or none has, and the map is the same as without
    /// landmarks; the report then says where the map has put them.
    std::vector<Landmark> landmarks{};
    /// Where the landmarks are on the first body, one each, to tell swapped ones; empty if that is not known.
    std::vector<glm::dvec3> counterparts{};
    /// Names of landmarks that mirror each other. Pairs without both landmarks mean nothing.
    std::vector<std::array<std::string, 2>> symmetric{};

    bool keep_largest = false;  ///< keeps the largest part, however much area is lost
    bool fill_holes = false;    ///< fills holes, however much area that adds
};

struct FitReport {
    CleanUpReport clean_up;
    std::size_t mesh_vertices = 0;  ///< of the cleaned surface
    std::size_t mesh_triangles = 0;
    MapMethod map_method = MapMethod::progressive;
    Keeps map_keeps = Keeps::shapes;
    double mean_cosine = 0;  ///< between directions on the sphere and directions in space (alignment.h)
    std::optional<MatchReport> match{};  ///< if the options name a model
    FitQuality at_20000_leaves;          ///< the basis of acceptance
    FitQuality quality;                  ///< of the key
    /// The largest distance between the key and the input mesh, with all parts and holes of that mesh, as a
    /// fraction of the diagonal of its box.
    double hausdorff_as_brought = 0;

    std::vector<FittedLandmark> landmarks;     ///< in the order of FitOptions
    std::vector<std::string> landmark_faults;  ///< sentences about landmarks that are probably wrong

    std::vector<StageTime> times;
};

struct FittedKey {
    Hierarchy hierarchy;  ///< with the scalars of the mesh, and the field "color" if it has colors
    FitReport report;
    SurfaceMesh mesh;  ///< the cleaned mesh, which the key represents; empty from fit_mapped()

    /// The mesh whose map the key is sampled by, if it is a finer mesh of the same surface or approximates it
    /// closely (surface_approximation.h); else empty.
    SurfaceMesh fine_mesh;
    std::vector<glm::dvec3> points;  ///< that map: of the unit sphere, one per vertex

    const SurfaceMesh& mapped_mesh() const { return fine_mesh.triangles.empty() ? mesh : fine_mesh; }
};

/// The name of the mapping method, for people and reports.
std::string_view name_of(MapMethod method);
std::string_view name_of(Keeps keeps);

/// Tries a map that keeps shapes first. If that map gives no good key, tries one that takes longer where vertices are
/// crowded, unless the mesh has large triangles, and then one that keeps areas.
/// \throw InputError  saying what is wrong with the mesh, what the clean-up would change without consent, or
///                    why no key represents the mesh well enough, or which landmark prevents it
/// \throw UsageError  if both leaves and tolerance are given, or one is out of its range; if only some of the
///                    landmarks have directions, or counterparts
/// \throw Cancelled   when \p progress says so
FittedKey fit(SurfaceMesh mesh, const FitOptions& options, const Progress& progress = {});

/// The part of fit() after the clean-up.
FittedKey fit(CleanMesh clean, const FitOptions& options, const Progress& progress = {});

/// As fit(), but the map continues that of a key before (continued_map.h), for a surface that has moved a little and is
/// meshed anew. Neither \a rotation nor \a model of the options counts.
/// \param before  a key of the surface before
/// \param wanted  the quality of a key with a map of its own, than which this key is hardly worse
/// \return none if the map cannot be continued, or gives no good key
/// \throw InputError, UsageError, Cancelled  as fit()
std::optional<FittedKey> fit_continued(const CleanMesh& clean, const FittedKey& before,
                                       const FitQuality& wanted, const FitOptions& options,
                                       const Progress& progress = {});

/// The part of fit() after the map to the sphere: aligns \p points, samples, and accepts or refuses the key.
/// \param mesh    clean
/// \param points  the map of \p mesh to the sphere, one point per vertex
FittedKey fit_mapped(const SurfaceMesh& mesh, std::vector<glm::dvec3> points, const FitOptions& options,
                     const Progress& progress = {});

}  // namespace interleaf
