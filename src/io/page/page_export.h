// Writes a family as one self-contained web page (.html), which shows it in a browser without a network.
#pragma once

#include "io/export/export.h"

namespace interleaf {

/// Writes the keys as page_payload() packs them, into the embedded page. The page may load nothing: its
/// content policy allows its own script and style, by their hashes.
/// \throw InputError    as page_payload(), and if more than 31 keys are blended at once
/// \throw MachineError  as ExportWriter
void export_page(const Export& exported, const OutputTarget& target);

}  // namespace interleaf
