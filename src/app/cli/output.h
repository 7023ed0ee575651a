// Where a command writes its result, and in which format, as the options -o and --format name them.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "io/file/output_target.h"
#include "io/formats.h"

namespace interleaf {

struct Output {
    std::string target;  ///< a file, or "-" for standard output
    std::string format;  ///< empty to go by the extension of the target
};

/// The format of \p output, one of \p known: named outright, or the extension of the file.
/// \throw UsageError when it is neither
std::string format_of(const Output& output, std::span<const std::string> known);

/// The names of the formats with this trait, without the dot of their extensions: "obj".
std::vector<std::string> format_names(FormatTrait trait);

OutputTarget target_of(const Output& output);

/// The target of a key: a file of a format for exported keys, or standard output for "-".
/// \throw UsageError when the file is of another format
OutputTarget key_target_of(const std::string& target);

}  // namespace interleaf
