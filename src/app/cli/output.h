// The target and the format of a command's result, given by the options -o and --format.
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "io/file/output_target.h"
#include "io/formats.h"

namespace interleaf {

struct Output {
    std::string target;  ///< a file, or "-" for standard output
    std::string format;  ///< if empty, the extension of the target decides
};

/// The format of \p output: the named format or, without one, the extension of the target.
/// \param known  formats that are allowed, without the dot of their extensions
/// \throw UsageError if the format is not in \p known, or standard output has no named format
std::string format_of(const Output& output, std::span<const std::string> known);

/// The names of the formats with \p trait, which are their extensions without the dot: "obj".
std::vector<std::string> format_names(FormatTrait trait);

OutputTarget target_of(const Output& output);

/// The target of a key: a file with the extension of an exported key format, or standard output for "-".
/// \throw UsageError if the file has another extension
OutputTarget key_target_of(const std::string& target);

/// The name of a family that is written to \p folder: the name of the folder.
std::string family_name_for(const std::filesystem::path& folder);

}  // namespace interleaf
