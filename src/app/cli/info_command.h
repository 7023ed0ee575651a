// `interleaf info`: the figures of a key, a family or a mesh, for people or as JSON.
#pragma once

#include <filesystem>

namespace interleaf {

struct InfoOptions {
    std::filesystem::path file;  ///< one path that open_family() takes
    bool json = false;
};

/// Prints on standard output.
/// \throw InputError, MachineError
void run_info(const InfoOptions& options);

}  // namespace interleaf
