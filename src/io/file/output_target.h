// Where a writer puts its bytes: a file, written whole or not at all (safe_write.h), or standard output.
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string_view>

namespace interleaf {

struct OutputTarget {
    std::filesystem::path file;  ///< empty for standard output
};

/// \throw MachineError when it cannot be written
void write_output(const OutputTarget& target, std::span<const std::byte> bytes);
void write_output(const OutputTarget& target, std::string_view text);

}  // namespace interleaf
