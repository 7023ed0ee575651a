// A list of everything that can be done, found by typing a few letters.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ui/widgets/rect.h"
#include "ui/widgets/text_field.h"

namespace interleaf {

struct PaletteEntry {
    std::string name;
    std::string group;        ///< menu or kind, dim behind the name
    std::string shortcut;     ///< may be empty
    std::string description;  ///< below the list while the entry is selected
    std::string obstacle;     ///< why the entry cannot be chosen now; empty if it can
};

/// The entries that match \p search, the best first. A match in the name counts more than one in group or
/// description, unless the letters are scattered in the name. Among equal matches, entries that can be chosen come
/// first, then the order of \p entries decides.
/// \return indices into \p entries
std::vector<std::size_t> ranked_entries(std::string_view search, std::span<const PaletteEntry> entries);

/// Up, Down, Page Up and Page Down select, Enter or a click chooses, Esc or a click beside the list closes.
class CommandPalette {
  public:
    /// Opens the palette with an empty search.
    void open();

    /// Closes the palette, if it is open, with the next show(), as Esc does.
    void dismiss() { is_closing_ = is_open_; }

    bool is_open() const { return is_open_; }

    /// Shows the palette, if it is open, at the top of \p area. Call it in every frame, from the same place.
    /// \return the chosen entry, once; the palette is then closed
    std::optional<std::size_t> show(const Rect& area, std::span<const PaletteEntry> entries);

  private:
    void read_keys(std::size_t count, std::size_t page);
    void show_rows(std::span<const PaletteEntry> entries, const std::vector<std::size_t>& ranked,
                   float height);
    void choose(std::span<const PaletteEntry> entries, const std::vector<std::size_t>& ranked,
                std::size_t row);

    TextField search_;
    std::string last_search_;
    std::size_t selected_ = 0;  ///< row of the ranked entries
    std::optional<std::size_t> chosen_;
    bool is_open_ = false;
    bool is_closing_ = false;
    bool is_new_ = false;   ///< the keys that opened the palette are still down
    bool follows_ = false;  ///< the list scrolls to the selected row
};

}  // namespace interleaf
