// `interleaf lod`: cuts keys to a level of detail.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "hierarchy/triangle.h"
#include "io/hierarchy/hierarchy_file.h"

namespace interleaf {

struct LodOptions {
    std::filesystem::path input;      ///< a path that open_files() takes
    std::string output;               ///< an .ilh file or "-" for one key, a folder for a family
    std::optional<Index> leaves;      ///< maximum number of leaves per key
    std::optional<double> tolerance;  ///< distance from each key, as a fraction of the key's box diagonal
    HierarchyFileOptions form;        ///< of the key files
};

/// Cuts every key. A single key becomes a key file, a family stays a family with its timeline, its domain and
/// its origin. Prints one line per key on standard output, unless the key is written there.
/// \throw InputError, MachineError
/// \throw UsageError  unless exactly one of `leaves` and `tolerance` is set; if fewer leaves are asked for than
///     there are roots, or the tolerance is negative
void run_lod(const LodOptions& options);

}  // namespace interleaf
