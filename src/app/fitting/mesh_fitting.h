// Fitting in the window: the offer with its choices, the work on its thread, how far it is in front of all
// else, and what becomes of it.
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
        std::string reason;  ///< why they are no keys as they are; empty where their kind says so
        std::optional<NamedRoots> roots;     ///< to fit over; without, the person chooses among named_roots()
        std::optional<glm::dvec3> origin{};  ///< of the family that the keys are for
        std::optional<SurfaceExtent> reference{};  ///< of a key of that family
    };

    /// Offers to fit meshes; what comes of it goes to \p receiver. \pre it is not open
    void offer(Task task, Receiver receiver);

    /// Whether the offer or the work is in front of all else.
    bool is_open() const { return dialog_.is_open() || job_.has_value(); }

    /// Whether it needs to be shown again soon, though nothing else happens.
    bool is_working() const { return job_.has_value() || is_reading_; }

    /// The offer, while there is one; null otherwise.
    const FitDialog* offered() const { return dialog_.is_open() ? &dialog_ : nullptr; }

    /// Shows the offer or the work, if it is open, in the middle of \p area; call it in every frame from the
    /// same place.
    void show(const Rect& area, double now);

    /// Acts on the answer, and hands on the keys once the work is done; call it in every frame.
    /// \param density  framebuffer pixels per screen coordinate
    /// \return what went wrong, once
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
    std::vector<NamedRoots> roots_;  ///< that are offered
    bool are_roots_given_ = false;
    Receiver receiver_;

    FitDialog dialog_;
    std::optional<bool> answer_;  ///< whether to fit; waits for update()
    std::unique_ptr<MeshPreviews> previews_;
    std::vector<std::unique_ptr<MeshPreviews>> leaving_;  ///< of which one may still be reading a large file
    bool is_reading_ = false;

    std::optional<FitJob> job_;
    bool is_work_closed_ = false;  ///< the dialog of the work, since the work is done
    double started_ = 0;
};

}  // namespace interleaf
