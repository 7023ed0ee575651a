// Fitting in the window: the work on its thread, how far it is in front of all else, and what becomes of it.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/fit_files.h"
#include "ui/dialog.h"
#include "ui/rect.h"

namespace interleaf {

/// How finely shall \p meshes be fitted, over the roots of a cube?
Question question_about_fit(std::span<const std::filesystem::path> meshes);

/// What an answer to it says that is not to cancel.
FitOptions fit_options(const Answer& answer);

class MeshFitting {
  public:
    using Receiver = std::function<void(std::vector<Key>)>;

    /// Fits \p meshes and gives the keys to \p receiver. \pre it is not running
    void start(std::vector<std::filesystem::path> meshes, FitOptions options, Receiver receiver, double now);

    bool is_running() const { return job_.has_value(); }

    /// Draws it, if it is running, in the middle of \p area; call it in every frame from the same place.
    /// \return what went wrong, once
    std::optional<std::string> show(const Rect& area, double now);

  private:
    std::optional<FitJob> job_;
    Receiver receiver_;
    std::string title_;
    double started_ = 0;
};

}  // namespace interleaf
