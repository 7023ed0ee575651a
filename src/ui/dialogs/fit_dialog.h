// The offer to fit keys to meshes: how finely, over which roots, and how each mesh is turned over them,
// beside pictures of the meshes with the roots around them.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ui/dialogs/fit_tiles.h"
#include "ui/widgets/rect.h"
#include "ui/widgets/text_field.h"

namespace interleaf {

/// What a person chooses; numbers as they are typed.
struct FitChoices {
    struct Turn {
        int axis = 1;  ///< 0, 1, 2 for x, y, z
        std::string degrees = "0";
    };

    bool by_tolerance = false;  ///< rather than by a number of leaves
    std::string leaves = "20000";
    std::string tolerance = "0.1";  ///< percent of the box diagonal
    std::size_t roots = 0;          ///< index of FitOfferShown::roots
    std::vector<Turn> turns;        ///< one per mesh
    std::vector<std::size_t> ups;   ///< one per mesh: the axis that points up, 0, 1, 2 for X, Y, Z
    bool same_size = false;
    bool same_center = false;
    bool keep_largest = false;  ///< though others of the parts are large
    bool fill_holes = false;    ///< though they are large
};

struct FitOfferShown {
    std::string text;    ///< "Fit keys to these 2 meshes?"
    std::string detail;  ///< what it means
    std::vector<std::string> roots;
    std::string roots_remark;  ///< why there is only one kind of roots; empty where there are several
    std::vector<FitTile> meshes;
    bool can_be_placed = false;  ///< whether there are others to have the size and the place of
    std::string parts_remark;    ///< what is lost with the smaller parts; empty where that is next to nothing
    std::string holes_remark;    ///< what is added to fill holes; empty where that is next to nothing
    std::string fault;  ///< what is wrong with the choices, so that "Fit" cannot be pressed; "" for nothing
};

/// Enter fits, Esc leaves all as it is. Tab, Up and Down move between the rows; Left and Right choose in a
/// row.
class FitDialog {
  public:
    /// \param can_be_placed  whether size and place can be those of others; they are to be then, at first
    /// \pre it is not open
    void open(std::size_t mesh_count, bool can_be_placed);

    bool is_open() const { return is_open_; }

    /// What is chosen now: what the next show() is told about goes by it.
    const FitChoices& choices() const { return choices_; }

    /// What has the keyboard: "limit", "number", "roots", "size", "center", "meshes", "up", "axis",
    /// "degrees", "parts", "holes", "fit" or "cancel".
    std::string_view row() const;

    /// What was wrong with the choices when they were shown last, so that "Fit" could not be pressed; "" for
    /// nothing.
    const std::string& fault() const { return fault_; }

    /// The mesh whose rotation is shown.
    std::size_t selected_mesh() const { return mesh_; }

    /// Of the pictures, in screen coordinates; known once it has been shown.
    float tile_side() const { return tile_side_; }

    /// Draws it, if it is open, in the middle of \p area; call it in every frame from the same place.
    /// \return once, whether to fit
    std::optional<bool> show(const Rect& area, const FitOfferShown& shown);

  private:
    enum class Place : std::uint8_t {
        limit,
        number,
        roots,
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
    void show_placing();
    void show_up(const FitOfferShown& shown);
    void show_turn(const FitOfferShown& shown);
    void show_changes(const FitOfferShown& shown);
    void show_toggle(const char* label, bool& value, Place place);
    void show_buttons(const FitOfferShown& shown);
    void show_number(TextField& field, const char* name, float width, Place place, std::string& text,
                     const FitOfferShown& shown);
    std::string& number_text() { return choices_.by_tolerance ? choices_.tolerance : choices_.leaves; }

    bool is_open_ = false;
    bool is_new_ = false;  ///< the keys that opened it are still down
    std::optional<bool> pressed_;
    FitChoices choices_;
    Place focus_ = Place::number;
    bool has_focus_moved_ = false;  ///< so that its row must be scrolled into sight
    std::string fault_;
    std::size_t mesh_ = 0;
    std::size_t first_tile_ = 0;
    float tile_side_ = 1;
    TextField number_;
    TextField degrees_;
};

}  // namespace interleaf
