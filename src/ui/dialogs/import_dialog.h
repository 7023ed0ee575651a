// The dialog before a series is imported: which steps and fields, and how the keys are found. All choices have
// defaults, so that Enter suffices.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ui/widgets/rect.h"
#include "ui/widgets/text_field.h"

namespace interleaf {

/// The user's choices; texts as typed. Empty texts stand for the default.
struct ImportDialogChoices {
    std::string tolerance;  ///< percent of the range of each field; empty to keep the triangles of the steps
    std::string every = "1";       ///< number of steps from one that is taken to the next
    std::string roots;             ///< a file
    double factor = 1;             ///< of the warp
    std::string warp;              ///< name of a scalar; empty for none
    std::string displacement;      ///< name of a vector; empty for none
    std::size_t newest = 0;        ///< 0: all three corners are tried; else the corner, from 1
    std::vector<bool> are_wanted;  ///< per field
};

struct ImportDialogShown {
    std::string title;                 ///< "Import run.pvd"
    std::string detail;                ///< "12 steps, 5,304 triangles in the first"
    std::vector<std::string> fields;   ///< of points
    std::vector<std::string> scalars;  ///< that can be a warp
    std::vector<std::string> vectors;  ///< that can be a displacement
    std::string fault;                 ///< what is wrong with the choices; "" if nothing is
};

/// Enter imports, Esc cancels. Tab and Shift+Tab move between the texts and buttons.
class ImportDialog {
  public:
    /// \pre is_open() is false
    void open(ImportDialogChoices choices);

    bool is_open() const { return is_open_; }
    const ImportDialogChoices& choices() const { return choices_; }

    /// Draws the dialog, if it is open, in the middle of \p area. Call it in every frame, from the same place.
    /// \return whether to import, once
    std::optional<bool> show(const Rect& area, const ImportDialogShown& shown);

  private:
    void read_keys(const ImportDialogShown& shown);
    void focus(std::size_t row);
    void press(bool imports, const ImportDialogShown& shown);
    void show_text_row(std::size_t row, const ImportDialogShown& shown);
    void show_choices(const ImportDialogShown& shown);
    void show_fields(const ImportDialogShown& shown);

    static constexpr std::size_t text_row_count = 3;

    bool is_open_ = false;
    bool is_new_ = false;  ///< the keys that opened the dialog are still down
    std::optional<bool> pressed_;
    ImportDialogChoices choices_;
    std::size_t focus_ = 0;  ///< a row: the text rows come first
    std::array<TextField, text_row_count> texts_;
};

}  // namespace interleaf
