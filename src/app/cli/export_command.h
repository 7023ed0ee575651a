// `interleaf export`: writes the morphed union as a flat mesh, or as a key (paper, section 3.3).
#pragma once

#include "app/cli/morph_selection.h"
#include "app/cli/output.h"
#include "io/hierarchy/hierarchy_file.h"

namespace interleaf {

struct ExportOptions {
    MorphSelection morph;
    Output output;              ///< obj, ply or ilh
    HierarchyFileOptions form;  ///< of an ilh file
};

/// \throw InputError, UsageError, MachineError
void run_export(const ExportOptions& options);

}  // namespace interleaf
