// `interleaf make`: makes keys from formulas, and the built-in family of such keys.
#pragma once

#include <string>

#include "app/cli/output.h"
#include "io/hierarchy/hierarchy_file.h"
#include "shapes/shapes.h"

namespace interleaf {

struct MakeOptions {
    std::string name;  ///< a shape, or "five-keys" for the folder of the built-in family
    std::string output;
    ShapeBudget budget;
    HierarchyFileOptions form;
};

/// \throw UsageError, MachineError
void run_make(const MakeOptions& options);

/// Prints the names that can be made on standard output, one per line.
void list_shapes();

}  // namespace interleaf
