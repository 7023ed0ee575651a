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
#include "app/landmarks/landmark_editing.h"
#include "app/work/shown_job.h"
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
        std::optional<SurfaceExtent> reference{};    ///< extent of a key of that family
        std::string key_name{};                      ///< name of that family's first key
        std::optional<SharedHierarchy> first_key{};  ///< that key; none without a family
        std::vector<LandmarkDirection> landmarks{};  ///< of that family
    };

    /// Opens the fit dialog. \p receiver receives the fitted keys.
    /// \pre neither dialog nor work is open
    void offer(Task task, Receiver receiver);

    /// Offers the last fit once more, with its choices, and opens the landmark window.
    /// \pre can_offer_again(); neither dialog nor work is open
    void offer_again(Receiver receiver);

    /// Whether there was a fit of meshes that correspond.
    bool can_offer_again() const { return last_ && last_->can_be_matched(); }

    /// The meshes of the last fit.
    /// \pre can_offer_again()
    const std::vector<std::filesystem::path>& last_meshes() const { return last_->task.meshes; }

    /// Whether the fit dialog or the progress of the work is in front of the window.
    bool is_open() const { return dialog_.is_open() || job_.is_working(); }

    /// Whether work in progress needs new frames soon, even without input.
    bool is_working() const { return job_.is_working() || is_reading_ || landmarks_.is_working(); }

    /// The fit dialog while it is open; null otherwise.
    const FitDialog* offered() const { return dialog_.is_open() ? &dialog_ : nullptr; }

    const LandmarkEditing& landmarks() const { return landmarks_; }

    /// Shows the fit dialog or the progress, if open, in the middle of \p area. Call it in every frame from
    /// the same place.
    void show(const Rect& area, double now);

    /// Acts on the user's answer, and hands on the keys when the work is done. Call it in every frame.
    /// \param density  framebuffer pixels per screen coordinate
    /// \return         an error, reported once
    std::optional<std::string> update(float density, double now);

  private:
    /// What is fitted, with the landmarks set so far.
    struct Offer {
        Task task;
        LandmarkPoints points;  ///< of the first key, if there is one, and then of the meshes
        bool can_be_matched() const { return task.first_key.has_value() || task.meshes.size() > 1; }
    };
    /// A fit that was begun.
    struct LastFit : Offer {
        FitChoices choices;
    };
    bool can_be_placed() const { return offer_.task.meshes.size() > 1 || offer_.task.reference.has_value(); }
    void begin(Receiver receiver);
    void open_landmarks();
    void add_landmarks(FitTask& task) const;
    FitOfferShown offer_shown() const;
    std::vector<FitTile> tiles() const;
    void tell_changes(FitOfferShown& shown) const;
    void close_offer(bool is_accepted, double now);
    void start(double now);
    std::optional<std::string> hand_on_keys();

    Offer offer_;
    std::optional<LastFit> last_;
    LandmarkEditing landmarks_;
    std::vector<NamedRoots> roots_;  ///< the choices of the dialog
    Receiver receiver_;

    FitDialog dialog_;
    std::optional<bool> answer_;  ///< whether to fit; kept for update()
    std::unique_ptr<MeshPreviews> previews_;
    std::vector<std::unique_ptr<MeshPreviews>>
        leaving_;  ///< dismissed previews; one may still read a large file
    bool is_reading_ = false;

    ShownJob<FittedMeshes> job_;
};

}  // namespace interleaf
