// `interleaf view`: the window.
#pragma once

#include <filesystem>
#include <vector>

#include "app/window/viewer.h"

namespace interleaf {

struct ViewOptions {
    std::vector<std::filesystem::path>
        family;  ///< what open_family() takes: none for the built-in one; or meshes to fit
    ViewerOptions viewer;
};

/// \throw InputError, MachineError
void run_view(const ViewOptions& options);

}  // namespace interleaf
