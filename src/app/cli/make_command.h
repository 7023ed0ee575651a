// `interleaf make`: makes keys from formulas, the built-in family of such keys, and sequences.
#pragma once

#include <optional>
#include <string>

#include "app/cli/output.h"
#include "io/hierarchy/hierarchy_file.h"
#include "shapes/shapes.h"

namespace interleaf {

struct MakeOptions {
    std::string name;  ///< a shape; or "five-keys", "flow" or "catenoid", which become the folder of a family
    std::string output;
    ShapeBudget budget;              ///< of a shape; its tolerance also of a sequence
    std::optional<unsigned> steps;   ///< of a sequence
    std::optional<double> distance;  ///< between the rings of the catenoid
    HierarchyFileOptions form;
};

/// Shows the progress of a sequence on a terminal.
/// \throw UsageError, InputError, MachineError
void run_make(const MakeOptions& options);

/// Prints the names that can be made on standard output, one per line.
void list_shapes();

}  // namespace interleaf
