// The viewer: the interactive window.
#pragma once

#include <filesystem>
#include <optional>

#include "family/family.h"

namespace interleaf {

struct ViewerOptions {
    int width = 1280;  ///< of the window, screen coordinates
    int height = 800;
    std::optional<std::filesystem::path>
        trace;  ///< a file that gets one JSON line at every change of state, for tests and bug reports
};

/// Opens a window on \p family and returns when it is closed.
/// \throw MachineError when there is no display
void run_viewer(Family family, const ViewerOptions& options);

}  // namespace interleaf
