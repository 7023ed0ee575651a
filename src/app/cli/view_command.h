// `interleaf view`: opens the window.
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "app/window/viewer.h"
#include "family/family.h"

namespace interleaf {

struct ViewOptions {
    std::vector<std::filesystem::path>
        family;  ///< paths that open_files() takes; empty for the built-in family
    ViewerOptions viewer;
};

/// \throw UsageError, InputError, MachineError
void run_view(const ViewOptions& options);

}  // namespace interleaf
