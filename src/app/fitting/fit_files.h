// Fits keys to meshes from files: for `interleaf fit`, and for the window on a separate thread.
#pragma once

#include <array>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <glm/mat3x3.hpp>

#include "app/document/fit_comparison.h"
#include "app/work/background_job.h"
#include "fit/correspondence/match.h"
#include "fit/fit.h"
#include "fit/landmarks/landmark_report.h"
#include "fit/landmarks/landmark_targets.h"
#include "fit/placement.h"
#include "io/mesh/surface_file.h"

namespace interleaf {

/// The meshes to fit, and the options.
struct FitTask {
    std::vector<std::filesystem::path> meshes;
    FitOptions options;                 ///< without a rotation
    std::vector<glm::dmat3> rotations;  ///< one per mesh; empty for no rotation
    std::vector<UpAxis> ups;            ///< one per mesh; empty if y is up in all
    PlacingOptions placing;
    /// Matches the maps of all meshes to that of the existing first key or else of the first mesh; holds landmarks.
    bool matches = false;

    /// Per mesh, its landmarks as in its file; empty for a fit without. The landmarks of the first mesh are the
    /// targets of all others (fit/landmarks/landmark_targets.h), unless there are targets already. A mesh without
    /// any is fitted without.
    std::vector<std::vector<Landmark>> landmarks{};
    std::optional<LandmarkPlacing> landmark_placing{};
    std::vector<std::array<std::string, 2>>
        symmetric{};  ///< names of landmarks that mirror each other, in any mesh

    /// The targets of an existing family, with directions; there may be none. The family's first key.
    std::vector<Landmark> targets{};
    std::optional<Hierarchy> first_key{};

    /// The origin and the extent of existing keys that the new keys must match; by default those of the first
    /// mesh.
    std::optional<glm::dvec3> origin{};
    std::optional<SurfaceExtent> reference{};
};

struct FittedMesh {
    FittedKey key;
    std::vector<std::string> remarks;  ///< sentences about how the file was read
    std::string warning;               ///< on size and place relative to the first mesh; "" for none
    std::vector<std::string> landmark_warnings{};  ///< sentences about landmarks that are probably wrong
    std::optional<Similarity> placement{};         ///< by landmarks; the key is in the new place
    std::optional<MorphDistortion> distortion{};   ///< against the first key, with landmarks
};

/// Reads, cleans up, places and fits the meshes of a task, one after the other.
class MeshFitter {
  public:
    explicit MeshFitter(FitTask task) : task_(std::move(task)) {}

    /// Fits the next mesh.
    /// \pre a mesh is left
    /// \throw InputError naming the file, UsageError, MachineError, Cancelled as read_surface() and fit()
    FittedMesh fit_next(const Progress& progress);

    /// The landmarks to which those of the meshes correspond, with directions; without landmarks, or before the
    /// first mesh is fitted, there are none.
    const std::vector<Landmark>& targets() const { return task_.targets; }

    /// The origin, subtracted from all positions (family/origin.h); 0 before the first mesh is fitted.
    glm::dvec3 origin() const { return task_.origin.value_or(glm::dvec3(0)); }

  private:
    /// Keeps the first body as the model of the others, if they are to be matched.
    void keep_model(FittedKey& key, const Progress& progress);
    void model_first_key(const Progress& progress);
    CleanMesh clean_next(SurfaceFile surface, const Progress& progress);
    void aim_landmarks(CleanMesh& clean, FittedMesh& fitted);
    void judge_landmarks(FittedMesh& fitted);

    FitTask task_;
    std::size_t next_ = 0;
    std::unique_ptr<const MatchedBody> model_;
};

/// Fitted keys, each with its mesh.
struct FittedMeshes {
    Comparisons comparisons;
    glm::dvec3 origin{0};               ///< subtracted from all positions
    std::vector<std::string> warnings;  ///< sentences that name the mesh
    std::vector<LandmarkDirection> landmarks;
    double stretched = 0;  ///< the largest part of a matched body that is stretched more than 8 times
};

/// The fitted keys, named after the files of their meshes.
std::vector<Key> keys_of(const Comparisons& fitted);

/// Fits the meshes of \p task, one after the other, as work for a separate thread. Its stages are like "bunny.off:
/// sampling". It throws the exceptions of MeshFitter::fit_next().
BackgroundJob<FittedMeshes>::Work fit_work(FitTask task);

}  // namespace interleaf
