// Writers of one blend: as a mesh, or as a key (paper, section 3.3).
#pragma once

#include "io/export/export.h"

namespace interleaf {

/// \throw UsageError, MachineError as ExportWriter and blend_of()
void export_obj(const Export& exported, const OutputTarget& target);
void export_ply(const Export& exported, const OutputTarget& target);
void export_key(const Export& exported, const OutputTarget& target);

}  // namespace interleaf
