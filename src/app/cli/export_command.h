// `interleaf export`: writes the morphed union as a flat mesh or as a key (paper, section 3.3), or the whole
// family, or its timeline as a series of files.
#pragma once

#include <filesystem>

#include "app/cli/morph_selection.h"
#include "app/cli/output.h"
#include "io/export/export.h"
#include "io/hierarchy/hierarchy_file.h"

namespace interleaf {

struct ExportOptions {
    MorphSelection morph;
    Output output;                ///< one of the exported formats
    HierarchyFileOptions form;    ///< of an ilh file
    SeriesExportOptions series;   ///< of a pvd file
    std::filesystem::path times;  ///< a file of the times of a pvd file; empty for none
    bool segments = false;        ///< of a glb file: a mesh per interval of the timeline
};

/// \throw InputError, UsageError, MachineError
void run_export(const ExportOptions& options);

}  // namespace interleaf
