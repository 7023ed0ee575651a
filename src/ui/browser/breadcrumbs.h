// The path of a folder as a row of its parts, each to go to.
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

namespace interleaf {

/// The folders on the way from the root to \p folder, itself included.
std::vector<std::filesystem::path> folders_on_the_way(const std::filesystem::path& folder);

/// Shows as many of \p folders, from the last one back, as \p width has room for; an ellipsis stands for the
/// others and goes to the last of them.
/// \param focused  the one that has the keyboard; it is always shown, if need be as the ellipsis
/// \return the index of the one that was clicked
std::optional<std::size_t> breadcrumbs(const std::vector<std::filesystem::path>& folders, float width,
                                       std::optional<std::size_t> focused);

}  // namespace interleaf
