// `interleaf make`: keys from formulas, and the built-in family made of them.
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

/// Prints what can be made, one a line, on standard output.
void list_shapes();

}  // namespace interleaf
