// The path of a folder as a row of buttons, one per folder on the path.
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

namespace interleaf {

/// The folders on the path from the root to \p folder, including \p folder.
std::vector<std::filesystem::path> folders_on_the_way(const std::filesystem::path& folder);

/// Shows as many of \p folders, from the last one back, as fit into \p width. An ellipsis stands for the
/// others, and leads to the last of them.
/// \param focused  index of the folder that has the keyboard; it is always shown, if necessary as the
///     ellipsis
/// \return index of the clicked folder
std::optional<std::size_t> breadcrumbs(const std::vector<std::filesystem::path>& folders, float width,
                                       std::optional<std::size_t> focused);

}  // namespace interleaf
