// The dialog before a picture or a film is made: the size and what is drawn of a picture, the times of a film and how
// the camera turns, beside a preview of the first frame.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include <glm/vec2.hpp>

#include "ui/widgets/rect.h"
#include "ui/widgets/text_field.h"

namespace interleaf {

/// The user's choices, as typed.
struct FilmChoices {
    std::string size = "1280x720";  ///< pixels
    std::string scale = "1";        ///< of a picture: a factor of its size and of the width of its lines
    std::string rate = "30";        ///< frames per second
    std::string begin;
    std::string end;
    std::string turn = "0";  ///< degrees
    bool is_loop = false;
    bool is_transparent = false;  ///< a picture without background
    bool has_edges = true;        ///< a picture with the edges that the window shows
    bool has_legend = true;       ///< of the colors, if they have one
};

struct FilmOfferShown {
    std::string title;           ///< "Film spin.mp4"
    std::string detail;          ///< "301 frames, 10 s"
    bool is_film = true;         ///< whether it has times; if not, it is a single picture
    bool offers_legend = false;  ///< whether the colors have one
    bool shows_edges = false;    ///< whether the window shows edges, so that a picture can leave them out
    unsigned preview = 0;        ///< OpenGL name of the texture of the first frame; 0 for none
    float aspect = 16 / 9.F;     ///< width / height of the frames
    std::string fault;  ///< what is wrong with the choices, so that nothing can be made; "" if nothing is
};

/// Enter makes the film, Esc cancels. Tab, Up and Down move between the rows.
class FilmDialog {
  public:
    /// \pre is_open() is false
    void open(FilmChoices choices);

    /// Closes the dialog, if it is open, with the next show(), as Esc does.
    void dismiss() {
        if (is_open_) pressed_ = false;
    }

    bool is_open() const { return is_open_; }
    const FilmChoices& choices() const { return choices_; }

    /// The row that has the keyboard: "size", "scale", "rate", "begin", "end", "turn", "loop", "transparent", "edges",
    /// "make" or "cancel".
    std::string_view row() const;

    /// Width of the preview, in screen coordinates; known after the first show().
    float preview_width() const { return preview_width_; }

    /// Draws the dialog, if it is open, in the middle of \p area. Call it in every frame, from the same place.
    /// \return whether to make the film, once
    std::optional<bool> show(const Rect& area, const FilmOfferShown& shown);

  private:
    void read_keys(const FilmOfferShown& shown);
    void focus(std::size_t row);
    void move_focus(int by, const FilmOfferShown& shown);
    void press(bool makes, const FilmOfferShown& shown);
    std::string& text_of(std::size_t row);
    void show_preview(const FilmOfferShown& shown);
    void show_text_row(std::size_t row, const FilmOfferShown& shown);
    void show_check_row(std::size_t row);
    void draw_pattern(glm::vec2 corner, glm::vec2 size) const;

    static constexpr std::size_t text_row_count = 6;

    bool is_open_ = false;
    bool is_new_ = false;  ///< the keys that opened the dialog are still down
    std::optional<bool> pressed_;
    FilmChoices choices_;
    std::size_t focus_ = 0;  ///< a row: the text rows come first
    float preview_width_ = 1;
    std::array<TextField, text_row_count> fields_;
};

}  // namespace interleaf
