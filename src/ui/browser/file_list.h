// The list of the file browser: one row per entry, with columns to sort by. Only the rows in sight are drawn.
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
    std::span<const std::size_t> shown;  ///< indices of entries, a row each
    const ListSelection& selection;      ///< of rows
    SortOrder order;
    bool is_focused = false;                   ///< the rows have the keyboard
    std::optional<SortColumn> focused_column;  ///< or this heading
    bool scroll_to_cursor = false;
};

struct FileListResult {
    std::optional<std::size_t> clicked;  ///< a row
    SelectionStep step = SelectionStep::only;
    bool is_double_click = false;
    std::optional<SortColumn> sort_by;  ///< a heading was clicked
    std::size_t rows_in_sight = 1;      ///< whole ones
};

FileListResult file_list(glm::vec2 size, const FileListState& state);

/// The columns that a list of this width has room for, from left to right.
std::span<const SortColumn> columns_in(float width);

}  // namespace interleaf
