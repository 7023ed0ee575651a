// `interleaf info`: prints the figures of a key, a family or a mesh, as text or as JSON.
#pragma once

#include <filesystem>

namespace interleaf {

struct InfoOptions {
    std::filesystem::path file;  ///< a path that open_family() takes
    bool json = false;
};

/// Prints the figures on standard output.
/// \throw InputError, MachineError
void run_info(const InfoOptions& options);

}  // namespace interleaf
