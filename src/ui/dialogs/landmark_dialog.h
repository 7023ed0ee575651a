// The landmark window: two meshes side by side, the list of landmarks, and the blend that they give.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <imgui.h>

#include "ui/dialogs/landmark_pictures.h"
#include "ui/widgets/rect.h"
#include "ui/widgets/text_field.h"

namespace interleaf {

/// A row of the list.
struct LandmarkRow {
    std::string name;
    std::string state;  ///< "only on cow.obj"; empty for a landmark with its partner
    ImU32 color = 0;    ///< of its marks
};

struct LandmarkDialogShown {
    std::array<LandmarkPictureShown, 2> sides;  ///< of the first mesh, of the chosen other one
    LandmarkPictureShown blend;
    std::vector<std::string> others;  ///< names of the meshes that the second side can show
    std::size_t other = 0;
    std::vector<LandmarkRow> rows;
    std::optional<std::size_t> selected;
    std::string name_fault;  ///< what is wrong with the typed name; "" if nothing is
    std::vector<std::string> warnings;
    bool can_undo = false;
    bool can_redo = false;
    bool can_swap = false;
    std::array<bool, 2> can_save{};  ///< whether the sides have landmarks
};

/// What the user did.
struct LandmarkDialogResult {
    std::array<LandmarkPictureInput, 2> sides;
    LandmarkPictureInput blend;
    std::optional<std::size_t> selected;
    std::optional<std::size_t> other;
    std::optional<std::string> name;  ///< for the selected landmark
    std::optional<bool> closes;       ///< true: use the landmarks; false: leave them as they were
    std::optional<std::size_t> side;  ///< the keyboard acts on it from now on
    int steps_proposal = 0;           ///< to the next or the previous one
    bool accepts_proposal = false;
    bool removes = false;
    bool swaps = false;
    bool undoes = false;
    bool redoes = false;
    std::optional<std::size_t> loads;  ///< the side that gets the landmarks of a file
    std::optional<std::size_t> saves;  ///< the side whose landmarks become a file

    bool is_any() const;
};

class LandmarkDialog {
  public:
    /// \pre is_open() is false
    void open();
    bool is_open() const { return is_open_; }

    /// Where the slider is: 0 for the first mesh, 1 for the other one.
    float blend() const { return blend_; }
    bool has_checker() const { return has_checker_; }
    bool turns_together() const { return turns_together_; }

    /// Sizes of the pictures, in screen coordinates; known after the first show().
    glm::vec2 side_size() const { return side_size_; }
    glm::vec2 blend_size() const { return blend_size_; }

    /// What is typed as the name of the selected landmark.
    const std::string& typed_name() const { return name_.text(); }

    /// Draws the window, if it is open, over \p area. Call it in every frame, from the same place.
    LandmarkDialogResult show(const Rect& area, const LandmarkDialogShown& shown);

  private:
    void read_keys(const LandmarkDialogShown& shown, LandmarkDialogResult& result);
    LandmarkPictureInput read_picture_keys(const LandmarkPictureShown& picture) const;
    void show_column(const LandmarkDialogShown& shown, LandmarkDialogResult& result);
    void show_rows(const LandmarkDialogShown& shown, LandmarkDialogResult& result, float height);
    void show_name(const LandmarkDialogShown& shown, LandmarkDialogResult& result);
    void show_edits(const LandmarkDialogShown& shown, LandmarkDialogResult& result) const;
    void show_blend(const LandmarkDialogShown& shown, LandmarkDialogResult& result);
    void show_foot(const LandmarkDialogShown& shown, LandmarkDialogResult& result);

    bool is_open_ = false;
    bool is_new_ = false;  ///< the keys that opened the window are still down
    float blend_ = 0.5F;
    bool has_checker_ = false;
    bool turns_together_ = true;
    std::size_t side_ = 0;  ///< the side of the keyboard
    bool edits_name_ = false;
    std::optional<std::size_t> named_;  ///< the landmark whose name the field has
    TextField name_;
    glm::vec2 side_size_{1};
    glm::vec2 blend_size_{1};
    std::array<LandmarkHold, 3> holds_;
};

}  // namespace interleaf
