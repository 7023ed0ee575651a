// A regular file, open for reading, whose size is known before any byte is read.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>

#include "io/file/file_descriptor.h"

namespace interleaf {

class InputFile {
  public:
    /// \throw InputError   if \p file is not a regular file
    /// \throw MachineError if it cannot be opened
    explicit InputFile(std::filesystem::path file);

    std::uint64_t size() const { return size_; }

    /// Fills \p bytes, starting where the last read ended.
    /// \throw InputError   if the file has fewer bytes left
    /// \throw MachineError if the file cannot be read
    void read(std::span<std::byte> bytes);

  private:
    std::filesystem::path path_;
    FileDescriptor descriptor_;
    std::uint64_t size_ = 0;
};

/// The whole content of a text file.
/// \throw InputError   if \p file is not a regular file, or is larger than \p size_limit bytes
/// \throw MachineError if it cannot be opened or read
std::string read_text(const std::filesystem::path& file, std::uint64_t size_limit);

}  // namespace interleaf
