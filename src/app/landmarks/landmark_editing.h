// The landmark window at work: applies what the person does, keeps the pictures and the blend up to date.
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/landmarks/landmark_files.h"
#include "app/landmarks/landmark_points.h"
#include "app/landmarks/landmark_preview.h"
#include "app/landmarks/landmark_surface.h"
#include "ui/dialogs/landmark_dialog.h"
#include "ui/widgets/rect.h"

namespace interleaf {

class LandmarkEditing {
  public:
    struct Task {
        std::vector<LandmarkSource> sources;  ///< at least two; the first is the reference
        std::vector<std::string> names;       ///< one per source
        SphereRoots roots;
        LandmarkPoints points;
        std::size_t other = 1;  ///< the mesh that is shown first beside the reference
    };

    /// \pre is_open() is false
    void open(Task task);
    bool is_open() const { return dialog_.is_open(); }

    /// Whether the window needs new frames soon, even without input.
    bool is_working() const;

    /// Shows the window, if it is open, over \p area. Call it in every frame from the same place.
    void show(const Rect& area);

    /// Applies what the person did. Call it in every frame.
    /// \param density  framebuffer pixels per screen coordinate
    /// \return the landmarks to use, once
    /// \pre a GL context is current
    std::optional<LandmarkPoints> update(float density);

    const LandmarkPoints& points() const { return history_.points(); }
    std::optional<std::size_t> selected() const { return selected_; }

    /// Whether the blend of the two shown meshes is made by the present landmarks.
    bool has_blend() const;

  private:
    std::size_t mesh_of(std::size_t side) const { return side == 0 ? 0 : other_; }
    LandmarkFiles::Mesh file_mesh(std::size_t side) const {
        return {mesh_of(side), task_.names[mesh_of(side)], task_.sources[mesh_of(side)].file};
    }
    glm::dvec3 shown_place(std::size_t mesh, const glm::dvec3& place) const;
    glm::dvec3 file_place(std::size_t mesh, const glm::dvec3& place) const;
    std::vector<Landmark> shown_landmarks(std::size_t mesh) const;
    std::vector<glm::dvec3> free_proposals(std::size_t side) const;
    std::shared_ptr<const LandmarkBlend> present_blend() const;

    LandmarkDialogShown shown() const;
    LandmarkPictureShown side_shown(std::size_t side, const std::vector<ImU32>& colors) const;
    std::vector<ImU32> mark_colors() const;

    void apply(const LandmarkDialogResult& done);
    void apply_to_side(std::size_t side, const LandmarkPictureInput& input);
    void add(std::size_t side, const glm::dvec3& place);
    void select_unpaired();
    void step_proposal(int by);
    void wish_blend();
    void follow_work(float density);

    Task task_;
    LandmarkHistory history_;
    std::optional<std::size_t> selected_;
    std::size_t other_ = 1;
    std::size_t side_ = 0;                       ///< on which the keyboard acts
    std::optional<glm::dvec3> chosen_proposal_;  ///< on that side
    LandmarkDialog dialog_;
    LandmarkFiles files_;                       ///< in place of the dialog while it asks
    bool has_dragged_ = false;                  ///< the present step of the history is the drag in progress
    std::optional<LandmarkDialogResult> done_;  ///< kept for update()
    std::array<LandmarkSurface, 2> sides_;
    LandmarkSurface blend_;
    std::array<std::shared_ptr<const LandmarkBody>, 2> bodies_;
    std::unique_ptr<LandmarkPreview> preview_;
    std::vector<std::unique_ptr<LandmarkPreview>> leaving_;  ///< of closed windows; one may still read
    std::vector<Landmark> wished_first_;
    std::vector<Landmark> wished_other_;
    std::size_t wished_mesh_ = 0;  ///< 0 before the first wish
};

}  // namespace interleaf
