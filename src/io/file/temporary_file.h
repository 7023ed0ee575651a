// A file that is written beside its target and then replaces the target.
//
// Its name is .interleaf-N, with the first N that no running process uses. Each process locks its temporary
// file, and the system releases the lock when the process ends, however it ends. So the next writer in the
// folder can remove the file of a killed process, and there are never more such files than there were
// simultaneous writers.
// A program that starts removes none, because it cannot know in which folders others wrote.
#pragma once

#include <filesystem>

#include "io/file/file_descriptor.h"

namespace interleaf {

class TemporaryFile {
  public:
    /// Makes an empty file in \p folder with the permissions \p mode, minus the umask. If that fails,
    /// is_open() is false and errno holds the reason.
    TemporaryFile(const std::filesystem::path& folder, unsigned mode);
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;

    /// Removes the file unless it was renamed.
    ~TemporaryFile();

    bool is_open() const { return descriptor_.is_open(); }
    const FileDescriptor& descriptor() const { return descriptor_; }
    const std::filesystem::path& path() const { return path_; }

    /// \return whether the file has the name \p target now; otherwise errno holds the reason
    bool rename_to(const std::filesystem::path& target);

  private:
    std::filesystem::path path_;
    FileDescriptor descriptor_;
    bool renamed_ = false;
};

}  // namespace interleaf
