// `interleaf view`: the window.
#pragma once

#include <filesystem>
#include <optional>

#include "app/viewer.h"

namespace interleaf {

struct ViewOptions {
    std::optional<std::filesystem::path> family;  ///< none for the built-in family
    ViewerOptions viewer;
};

/// \throw InputError, MachineError
void run_view(const ViewOptions& options);

}  // namespace interleaf
