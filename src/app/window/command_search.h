// Searches commands, keys and recent files by name, and runs what is chosen.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <vector>

#include "app/document/viewer_state.h"
#include "app/window/shortcuts.h"
#include "ui/dialogs/command_palette.h"
#include "ui/widgets/rect.h"

namespace interleaf {

/// All commands but those of the palette itself, then one entry per key, then one per recent file.
struct SearchEntries {
    std::vector<PaletteEntry> shown;
    std::vector<std::size_t> commands;  ///< indices into commands()
    std::size_t keys = 0;
};

SearchEntries search_entries(const ViewerState& state, const Shortcuts& shortcuts,
                             std::span<const std::filesystem::path> recent_files);

class CommandSearch {
  public:
    bool is_open() const { return palette_.is_open(); }

    /// Closes the palette, if it is open, with the next show().
    void dismiss() { palette_.dismiss(); }

    /// Shows the palette, if it is open, in \p area. Call it in every frame, from the same place.
    void show(const Rect& area, const ViewerState& state, const Shortcuts& shortcuts,
              std::span<const std::filesystem::path> recent_files);

    /// Carries out what was chosen. Opens the palette if a command has asked for it.
    /// \return the recent file to open, an index
    std::optional<std::size_t> act(ViewerState& state, double now);

  private:
    CommandPalette palette_;
    SearchEntries entries_;
    std::optional<std::size_t> chosen_;  ///< waits for act()
};

}  // namespace interleaf
