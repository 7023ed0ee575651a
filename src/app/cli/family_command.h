// `interleaf family`: makes a family folder from key files.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/cli/adapt_command.h"
#include "family/blend_kind.h"
#include "family/field_units.h"
#include "family/interpolation.h"
#include "io/hierarchy/hierarchy_file.h"

namespace interleaf {

struct FamilyOptions {
    std::vector<std::filesystem::path> keys;  ///< paths that open_family() takes
    std::filesystem::path output;             ///< the folder
    AdaptOptions adapt;                       ///< instead of keys, if it names a shape
    std::optional<Basis> basis;               ///< of the timeline; by default the present one
    std::optional<std::size_t> degree;        ///< of the pieces of Basis::bernstein
    std::optional<BlendKind> blend;           ///< by default the present one
    std::vector<NamedUnit> units;             ///< of fields of the keys
    std::optional<std::string> time_unit;     ///< of the timeline; by default the present one
    HierarchyFileOptions form;                ///< of the key files
};

/// Opens the keys, puts them over the same roots and writes the family. Names on standard error the keys that
/// had to be changed.
/// \throw InputError, MachineError
/// \throw UsageError if the options do not fit the timeline
void run_family(const FamilyOptions& options);

}  // namespace interleaf
