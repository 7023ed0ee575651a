// `interleaf view`: opens the window.
#pragma once

#include <filesystem>
#include <vector>

#include "app/window/viewer.h"

namespace interleaf {

struct ViewOptions {
    std::vector<std::filesystem::path>
        family;  ///< paths that open_files() takes; empty for the built-in family
    ViewerOptions viewer;
};

/// \throw InputError, MachineError
void run_view(const ViewOptions& options);

}  // namespace interleaf
