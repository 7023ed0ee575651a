// The folder where the file browser starts when the user saves a document in a folder of its own, and its name.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace interleaf {

/// The folders that a person works with. None of them needs to exist.
struct SaveSurroundings {
    std::optional<std::filesystem::path> document;  ///< the folder of the document
    std::filesystem::path last;                     ///< the folder shown last; empty for none
    std::filesystem::path current;                  ///< the program's working folder; empty for none
    std::filesystem::path builtin;                  ///< holds the built-in families; never used for saving
};

/// The folder beside the document; otherwise the last or the current folder. If that folder is itself a
/// family, its parent, because families are not nested. Never a folder of the built-in families. Empty if
/// there is none, which stands for the home folder.
std::filesystem::path folder_to_save_in(const SaveSurroundings& around);

/// \p name of a family as the name of a file or a folder; "family" if it is empty.
std::string folder_name(std::string name);

}  // namespace interleaf
