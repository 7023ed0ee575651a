// The offer to fit keys to meshes. The user chooses the limit, the roots and the turn of each mesh, beside
// pictures of the meshes with the roots around them.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "ui/dialogs/fit_tiles.h"
#include "ui/widgets/rect.h"
#include "ui/widgets/text_field.h"

namespace interleaf {

/// The user's choices. Numbers are kept as typed.
struct FitChoices {
    struct Turn {
        int axis = 1;  ///< 0, 1, 2 for x, y, z
        std::string degrees = "0";
    };

    bool by_tolerance = false;  ///< the limit is a tolerance, not a number of leaves
    std::string leaves = "20000";
    std::string tolerance = "0.1";  ///< percent of the box diagonal
    std::size_t roots = 0;          ///< index into FitOfferShown::roots
    std::vector<Turn> turns;        ///< one per mesh
    std::vector<std::size_t> ups;   ///< one per mesh: the axis that points up; 0, 1, 2 for X, Y, Z
    bool match_parts = false;       ///< of all meshes with those of the first
    bool same_size = false;
    bool same_center = false;
    bool keep_largest = false;  ///< even if other parts are large
    bool fill_holes = false;    ///< even if the holes are large
};

struct FitOfferShown {
    std::string text;    ///< "Fit keys to these 2 meshes?"
    std::string detail;  ///< the consequences
    std::vector<std::string> roots;
    std::string roots_remark;  ///< the reason why there is only one kind of roots; empty if there are several
    std::vector<FitTile> meshes;
    bool can_be_matched = false;  ///< whether there is a mesh or a key whose parts can be matched
    std::string landmarks;        ///< how many are set: "5 pairs"; empty for none
    bool can_be_placed = false;   ///< whether there are other meshes or keys to match in size and center
    std::string parts_remark;     ///< what is lost with the smaller parts; empty if that is negligible
    std::string holes_remark;     ///< what is added to fill holes; empty if that is negligible
    std::string fault;  ///< what is wrong with the choices, so that "Fit" is disabled; "" if nothing is
};

/// Enter fits, Esc cancels. Tab, Up and Down move between the rows; Left and Right choose within a row.
class FitDialog {
  public:
    /// \param can_be_placed   whether there are other meshes or keys to match in size and center; if so, both
    ///     are matched at first
    /// \param matches_parts   whether parts are matched at first
    /// \pre is_open() is false
    void open(std::size_t mesh_count, bool can_be_placed, bool matches_parts);

    /// Opens the dialog with the choices of an earlier one for the same meshes.
    /// \pre is_open() is false
    void open(FitChoices choices);

    bool is_open() const { return is_open_; }

    /// The current choices. The caller derives the argument of the next show() from them.
    const FitChoices& choices() const { return choices_; }

    /// Whether the user wants to set landmarks, once.
    bool wants_landmarks() { return std::exchange(wants_landmarks_, false); }

    /// The row that has the keyboard: "limit", "number", "roots", "match", "landmarks", "size", "center",
    /// "meshes", "up", "axis", "degrees", "parts", "holes", "fit" or "cancel".
    std::string_view row() const;

    /// What was wrong with the choices in the last show(), so that "Fit" was disabled; "" if nothing was.
    const std::string& fault() const { return fault_; }

    /// The mesh whose rotation is shown.
    std::size_t selected_mesh() const { return mesh_; }

    /// Side of the pictures, in screen coordinates; known after the first show().
    float tile_side() const { return tile_side_; }

    /// Draws the dialog, if it is open, in the middle of \p area. Call it in every frame, from the same
    /// place.
    /// \return whether to fit, once
    std::optional<bool> show(const Rect& area, const FitOfferShown& shown);

  private:
    enum class Place : std::uint8_t {
        limit,
        number,
        roots,
        match,
        landmarks,
        size,
        center,
        meshes,
        up,
        axis,
        degrees,
        parts,
        holes,
        fit,
        cancel
    };

    void read_keys(const FitOfferShown& shown);
    void move_focus(int by, const FitOfferShown& shown);
    void focus(Place place);
    void step_choice(int by, const FitOfferShown& shown);
    void select_mesh(std::size_t mesh);
    void press(bool fit, const FitOfferShown& shown);
    void scroll_to_focus(Place place);
    void mark_focus(Place place);
    void show_meshes(const FitOfferShown& shown);
    void show_limit(const FitOfferShown& shown);
    void show_roots(const FitOfferShown& shown);
    void show_matching(const FitOfferShown& shown);
    void show_placing();
    void show_up(const FitOfferShown& shown);
    void show_turn(const FitOfferShown& shown);
    void show_changes(const FitOfferShown& shown);
    void show_toggle(const char* label, bool& value, Place place, const char* tip);
    void show_number(TextField& field, const char* name, float width, Place place, std::string& text,
                     const FitOfferShown& shown);
    std::string& number_text() { return choices_.by_tolerance ? choices_.tolerance : choices_.leaves; }

    bool is_open_ = false;
    bool is_new_ = false;  ///< the keys that opened the dialog are still down
    std::optional<bool> pressed_;
    bool wants_landmarks_ = false;
    FitChoices choices_;
    Place focus_ = Place::number;
    bool has_focus_moved_ = false;  ///< the focused row must be scrolled into view
    std::string fault_;
    std::size_t mesh_ = 0;
    std::size_t first_tile_ = 0;
    float tile_side_ = 1;
    TextField number_;
    TextField degrees_;
};

}  // namespace interleaf
