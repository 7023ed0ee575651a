// Fits meshes in the window: shows the fit dialog with its choices, runs the fit on a separate thread, shows
// its progress in front of the window, and hands on the fitted keys.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/fitting/fit_choices.h"
#include "app/fitting/fit_files.h"
#include "app/fitting/mesh_previews.h"
#include "ui/dialogs/fit_dialog.h"
#include "ui/widgets/rect.h"

namespace interleaf {

class MeshFitting {
  public:
    using Receiver = std::function<void(FittedMeshes)>;

    struct Task {
        std::vector<std::filesystem::path> meshes;
        std::string reason;                  ///< why they are not keys; empty if their formats hold no keys
        std::optional<NamedRoots> roots;     ///< by default, the user chooses among named_roots()
        std::optional<glm::dvec3> origin{};  ///< of the family that receives the keys
        std::optional<SurfaceExtent> reference{};  ///< extent of a key of that family
    };

    /// Opens the fit dialog. \p receiver receives the fitted keys.
    /// \pre neither dialog nor work is open
    void offer(Task task, Receiver receiver);

    /// Whether the fit dialog or the progress of the work is in front of the window.
    bool is_open() const { return dialog_.is_open() || job_.has_value(); }

    /// Whether work in progress needs new frames soon, even without input.
    bool is_working() const { return job_.has_value() || is_reading_; }

    /// The fit dialog while it is open; null otherwise.
    const FitDialog* offered() const { return dialog_.is_open() ? &dialog_ : nullptr; }

    /// Shows the fit dialog or the progress, if open, in the middle of \p area. Call it in every frame from
    /// the same place.
    void show(const Rect& area, double now);

    /// Acts on the user's answer, and hands on the keys when the work is done. Call it in every frame.
    /// \param density  framebuffer pixels per screen coordinate
    /// \return         an error, reported once
    std::optional<std::string> update(float density, double now);

  private:
    bool can_be_placed() const { return meshes_.size() > 1 || reference_.has_value(); }
    FitOfferShown offer_shown() const;
    std::vector<FitTile> tiles() const;
    void tell_changes(FitOfferShown& shown) const;
    void close_offer(bool is_accepted, double now);
    void start(double now);
    void show_work(const Rect& area, double now);
    std::optional<std::string> hand_on_keys();

    std::vector<std::filesystem::path> meshes_;
    std::string reason_;
    std::optional<glm::dvec3> origin_;
    std::optional<SurfaceExtent> reference_;
    std::vector<NamedRoots> roots_;  ///< the choices of the dialog
    bool are_roots_given_ = false;
    Receiver receiver_;

    FitDialog dialog_;
    std::optional<bool> answer_;  ///< whether to fit; kept for update()
    std::unique_ptr<MeshPreviews> previews_;
    std::vector<std::unique_ptr<MeshPreviews>>
        leaving_;  ///< dismissed previews; one may still read a large file
    bool is_reading_ = false;

    std::optional<FitJob> job_;
    bool is_work_closed_ = false;  ///< whether the progress dialog has closed after the work
    double started_ = 0;
};

}  // namespace interleaf
