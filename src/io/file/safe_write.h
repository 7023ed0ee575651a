// Writes a file whole or not at all.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <string_view>

#include "io/file/temporary_file.h"

namespace interleaf {

/// Writes \p bytes to a temporary file beside \p file, flushes that file to the disk and renames it over
/// \p file. So \p file always has the old content or the new content, whole, even after a kill or a power
/// failure.
///
/// The new file has the permissions of the existing file, and its owner if the system permits. A
/// write-protected file is not replaced. A symbolic link is followed; other hard links keep the old content.
/// A device, such as /dev/null, is written to directly.
/// \throw MachineError naming the file and the error of the system
void write_file(const std::filesystem::path& file, std::span<const std::byte> bytes);
void write_file(const std::filesystem::path& file, std::string_view text);

/// The two halves of write_file(), for a file that another program writes: an empty temporary file, and its
/// renaming. Without commit() nothing changes.
class FileReplacement {
  public:
    /// \throw MachineError naming the file, if it cannot be replaced; also if it is a device or a folder
    explicit FileReplacement(const std::filesystem::path& file);

    /// The temporary file. It may be written to under this name, but not renamed.
    const std::filesystem::path& path() const { return temporary_->path(); }
    const FileDescriptor& descriptor() const { return temporary_->descriptor(); }

    /// Flushes the temporary file to the disk and gives it the name of the target.
    /// \throw MachineError
    void commit();

  private:
    std::filesystem::path target_;
    bool exists_ = false;
    std::optional<TemporaryFile> temporary_;
};

}  // namespace interleaf
