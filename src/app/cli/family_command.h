// `interleaf family`: makes a family folder from key files.
#pragma once

#include <filesystem>
#include <vector>

#include "io/hierarchy/hierarchy_file.h"

namespace interleaf {

struct FamilyOptions {
    std::vector<std::filesystem::path> keys;  ///< paths that open_family() takes
    std::filesystem::path output;             ///< the folder
    HierarchyFileOptions form;                ///< of the key files
};

/// Opens the keys, puts them over the same roots and writes the family. Names on standard error the keys that
/// had to be changed.
/// \throw InputError, MachineError
void run_family(const FamilyOptions& options);

}  // namespace interleaf
