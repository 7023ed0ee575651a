// The list of the file browser: one row per entry, with columns to sort by. Draws only the visible rows.
#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include <glm/vec2.hpp>

#include "ui/browser/folder_listing.h"
#include "ui/widgets/list_selection.h"

namespace interleaf {

struct FileListState {
    std::span<const FolderEntry> entries;
    std::span<const std::size_t> shown;  ///< indices into entries, one per row
    const ListSelection& selection;      ///< selected rows
    SortOrder order;
    bool is_focused = false;                   ///< the rows have the keyboard
    std::optional<SortColumn> focused_column;  ///< heading that has the keyboard
    bool scroll_to_cursor = false;
};

struct FileListResult {
    std::optional<std::size_t> clicked;  ///< clicked row
    SelectionStep step = SelectionStep::only;
    bool is_double_click = false;
    std::optional<SortColumn> sort_by;  ///< clicked heading
    std::size_t rows_in_sight = 1;      ///< number of fully visible rows
};

FileListResult file_list(glm::vec2 size, const FileListState& state);

/// The columns that fit into a list of this width, from left to right.
std::span<const SortColumn> columns_in(float width);

}  // namespace interleaf
