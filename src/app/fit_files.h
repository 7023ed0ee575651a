// Meshes from files made keys: what `interleaf fit` does, and the window on a thread of its own.
#pragma once

#include <exception>
#include <filesystem>
#include <mutex>
#include <span>
#include <string>
#include <thread>
#include <vector>

#include <glm/mat3x3.hpp>

#include "app/fit_comparison.h"
#include "fit/fit.h"

namespace interleaf {

/// Whether \p file is called as a mesh that only fit() makes a key of: .ply, .stl or .off.
bool is_surface_file(const std::filesystem::path& file);

/// Whether \p files are meshes of which one, by its kind, is no key as it is: together they must be fitted.
bool are_surfaces(std::span<const std::filesystem::path> files);

/// Whether \p files are all .obj: meshes that are keys as they are, several only if they have the same faces.
bool are_obj_files(std::span<const std::filesystem::path> files);

/// The key of the mesh in \p file.
/// \throw InputError naming the file, UsageError, MachineError, Cancelled as read_surface() and fit()
FittedKey fit_file(const std::filesystem::path& file, const FitOptions& options, const Progress& progress);

/// Keys of what was fitted, called as the files of the meshes.
std::vector<Key> keys_of(const Comparisons& fitted);

/// Fits several meshes, one after the other, on a thread of its own. Its members are called from one thread.
class FitJob {
  public:
    /// \param rotations  one a mesh, in place of the one in \p options
    FitJob(std::vector<std::filesystem::path> meshes, FitOptions options, std::vector<glm::dmat3> rotations);

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

    /// The keys, each beside its mesh. \pre it is done
    /// \throw what fit_file() threw
    Comparisons take();

  private:
    void work(const std::stop_token& stop);
    void report(const std::filesystem::path& mesh, std::string_view stage, double part);

    const std::vector<std::filesystem::path> meshes_;
    FitOptions options_;
    const std::vector<glm::dmat3> rotations_;

    mutable std::mutex mutex_;  ///< of what follows
    State state_;
    Comparisons fitted_;
    std::exception_ptr error_;

    std::jthread thread_;  ///< last, so that it ends before what it uses
};

}  // namespace interleaf
