// Writers of VTK files for ParaView: one blend as .vtp or .vtu, and the whole timeline as .pvd, a list of .vtp
// files. Each triangle has its level, and the keys of the family in which it is a node as bits.
#pragma once

#include "io/export/export.h"

namespace interleaf {

/// \throw UsageError, MachineError as ExportWriter and blend_of()
void export_vtp(const Export& exported, const OutputTarget& target);
void export_vtu(const Export& exported, const OutputTarget& target);

/// Writes NAME.pvd, and NAME.0000.vtp and so on beside it (SeriesExportOptions). The .pvd file is written last.
/// Without a timeline, the one file is that of the chosen blend at time 0.
/// \throw UsageError   as blend_of(); if the times are those of a path and there is no number of frames per
///                     second; if there are over 100,000 frames; or for standard output
/// \throw MachineError if a file cannot be written
void export_pvd(const Export& exported, const OutputTarget& target);

}  // namespace interleaf
