// Writes a family as binary glTF 2.0 (.glb): a mesh whose morph targets are the keys, over their union, and
// the timeline as an animation of the morph weights. docs/file-formats.md describes the layout.
#pragma once

#include "io/export/export.h"

namespace interleaf {

/// Writes the union of all keys as one mesh. The first key of the timeline is the base, each other key is a
/// morph target.
///
/// With Export::segments, each interval of the timeline is a mesh of its own, the union of its two keys, and
/// a node that is shown only in that interval. So are families with a linear timeline and without a domain
/// whose union of all keys has over four times the vertices of the union of any interval's two keys.
/// \throw UsageError    if segments are asked for, and the family has no linear timeline of at least two keys
/// \throw InputError    if the file would be larger than 4 GiB
/// \throw MachineError  as ExportWriter
void export_glb(const Export& exported, const OutputTarget& target);

}  // namespace interleaf
