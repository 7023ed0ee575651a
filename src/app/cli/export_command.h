// `interleaf export`: writes the morphed union as a flat mesh or as a key (paper, section 3.3), or the whole
// family.
#pragma once

#include "app/cli/morph_selection.h"
#include "app/cli/output.h"
#include "io/hierarchy/hierarchy_file.h"

namespace interleaf {

struct ExportOptions {
    MorphSelection morph;
    Output output;
    HierarchyFileOptions form;  ///< of an ilh file
    bool segments = false;      ///< of a glb file: a mesh per interval of the timeline
};

/// \throw InputError, UsageError, MachineError
void run_export(const ExportOptions& options);

}  // namespace interleaf
