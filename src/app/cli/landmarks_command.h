// `interleaf landmarks`: proposes landmarks of a mesh.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

namespace interleaf {

struct LandmarksOptions {
    std::filesystem::path mesh;
    std::string output;  ///< a .json file, or "-" for standard output
    std::size_t max_count = 16;
};

/// Writes a landmark file with the extremities of the mesh, the most prominent first. Prints them on standard
/// output, unless the file is written there.
/// \throw InputError, UsageError, MachineError
void run_landmarks(const LandmarksOptions& options);

}  // namespace interleaf
