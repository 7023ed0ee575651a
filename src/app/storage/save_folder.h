// Where the file browser begins when a document is to be saved in a folder of its own.
#pragma once

#include <filesystem>
#include <optional>

namespace interleaf {

/// What is known about where a person works; none of it need exist.
struct SaveSurroundings {
    std::optional<std::filesystem::path> document;  ///< the folder of the document
    std::filesystem::path last;                     ///< the folder that was shown last; empty for none
    std::filesystem::path current;                  ///< the folder the program was started in; empty for none
    std::filesystem::path builtin;                  ///< the built-in families are in it: not a place to save
};

/// The folder beside the document; or else the one shown last, or the current one. Of a folder that is a
/// family itself the one it is in, since families do not lie in each other; never one of the built-in
/// families. Empty where there is none, which stands for home.
std::filesystem::path folder_to_save_in(const SaveSurroundings& around);

}  // namespace interleaf
