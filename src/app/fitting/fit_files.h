// Meshes from files made keys: what `interleaf fit` does, and the window on a thread of its own.
#pragma once

#include <exception>
#include <filesystem>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <glm/mat3x3.hpp>

#include "app/document/fit_comparison.h"
#include "fit/fit.h"
#include "fit/placement.h"
#include "io/mesh/surface_file.h"

namespace interleaf {

/// What is to be fitted, and how.
struct FitTask {
    std::vector<std::filesystem::path> meshes;
    FitOptions options;                 ///< in which the rotation is left out
    std::vector<glm::dmat3> rotations;  ///< one per mesh; empty for none
    std::vector<UpAxis> ups;            ///< one per mesh; empty where all have y up
    PlacingOptions placing;

    /// What keys that are there already have, which these are to go with; else the first mesh decides.
    std::optional<glm::dvec3> origin{};
    std::optional<SurfaceExtent> reference{};
};

struct FittedMesh {
    FittedKey key;
    std::vector<std::string> remarks;  ///< sentences about how the file was read
    std::string warning;               ///< about its size and place beside the first; "" for none
};

/// Reads, cleans up, places and fits the meshes of a task, one after the other.
class MeshFitter {
  public:
    explicit MeshFitter(FitTask task) : task_(std::move(task)) {}

    /// \pre there is a mesh left
    /// \throw InputError naming the file, UsageError, MachineError, Cancelled as read_surface() and fit()
    FittedMesh fit_next(const Progress& progress);

    /// What was subtracted from all positions (family/origin.h); 0 before the first is fitted.
    glm::dvec3 origin() const { return task_.origin.value_or(glm::dvec3(0)); }

  private:
    CleanMesh clean_next(SurfaceFile surface, const Progress& progress);

    FitTask task_;
    std::size_t next_ = 0;
};

/// Keys that have been fitted, each beside its mesh.
struct FittedMeshes {
    Comparisons comparisons;
    glm::dvec3 origin{0};               ///< that was subtracted from all positions
    std::vector<std::string> warnings;  ///< sentences that name the mesh
};

/// Keys of what was fitted, called as the files of the meshes.
std::vector<Key> keys_of(const Comparisons& fitted);

/// Fits several meshes, one after the other, on a thread of its own. Its members are called from one thread.
class FitJob {
  public:
    explicit FitJob(FitTask task);

    /// Cancels what is not done.
    ~FitJob() = default;
    FitJob(const FitJob&) = delete;
    FitJob& operator=(const FitJob&) = delete;

    struct State {
        std::string stage;  ///< "bunny.off: sampling"
        double part = 0;    ///< of the whole, 0 to 1
        bool is_done = false;
    };
    State state() const;

    /// It is done soon after.
    void cancel() { thread_.request_stop(); }

    /// \pre it is done
    /// \throw what MeshFitter::fit_next() threw
    FittedMeshes take();

  private:
    void work(const std::stop_token& stop);
    void report(const std::filesystem::path& mesh, std::string_view stage, double part);

    const std::vector<std::filesystem::path> meshes_;
    MeshFitter fitter_;

    mutable std::mutex mutex_;  ///< of what follows
    State state_;
    FittedMeshes fitted_;
    std::exception_ptr error_;

    std::jthread thread_;  ///< last, so that it ends before what it uses
};

}  // namespace interleaf
