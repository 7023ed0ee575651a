// Paths that the user types: relative to the shown folder, with ~ for the home folder, completed by Tab.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace interleaf {

/// The home folder, $HOME; "/" if that is not an absolute path.
std::filesystem::path home_folder();

/// The path that \p text means while \p folder is shown. Ignores blanks around the text, and one pair of
/// quotation marks around it, as a terminal would.
/// \return an absolute path, without "." and ".."
std::filesystem::path typed_path(std::string_view text, const std::filesystem::path& folder,
                                 const std::filesystem::path& home);

struct PathCompletion {
    std::string text;
    std::size_t names;  ///< number of names that begin with the typed text
};

/// Completes \p text by the names on disk: to the longest common beginning of all names that begin with it,
/// ignoring case only if no name matches exactly. Appends '/' to the only match if it is a folder. Leaves out
/// names that a text field cannot hold, and hidden names unless their dot is typed.
PathCompletion completed_path(std::string_view text, const std::filesystem::path& folder,
                              const std::filesystem::path& home);

}  // namespace interleaf
