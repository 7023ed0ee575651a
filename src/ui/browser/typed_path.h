// Paths that a person types: relative to the folder they see, with ~ for home, completed by Tab.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace interleaf {

/// The user's folder, $HOME; "/" where that is not an absolute path.
std::filesystem::path home_folder();

/// What \p text means to a person who sees \p folder. Blanks around it, and a pair of quotation marks as a
/// terminal would take them, are ignored.
/// \return an absolute path, without "." and ".."
std::filesystem::path typed_path(std::string_view text, const std::filesystem::path& folder,
                                 const std::filesystem::path& home);

struct PathCompletion {
    std::string text;
    std::size_t names;  ///< that begin as typed
};

/// \p text as far as the names on the disk complete it: the longest beginning that all names have which begin
/// so; in any case where none does exactly. A folder that is the only one gets its '/'. Names that a text
/// field cannot hold are left out, hidden ones are only meant by typing their dot.
PathCompletion completed_path(std::string_view text, const std::filesystem::path& folder,
                              const std::filesystem::path& home);

}  // namespace interleaf
