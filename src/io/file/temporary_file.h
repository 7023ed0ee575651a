// A file that is written beside its target and then takes the target's place.
//
// It is called .interleaf-N, with the first N that no living process uses: a lock tells, which the system
// takes off when a process ends, however it ends. So what a killed process left is removed by whoever writes
// into that folder next, and never is there more of it than there were writers at one time.
#pragma once

#include <filesystem>

#include "io/file/file_descriptor.h"

namespace interleaf {

class TemporaryFile {
  public:
    /// Makes an empty file in \p folder with the permissions \p mode, less the umask. See is_open() for the
    /// outcome; errno says why not.
    TemporaryFile(const std::filesystem::path& folder, unsigned mode);
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;

    /// Removes the file unless it was renamed.
    ~TemporaryFile();

    bool is_open() const { return descriptor_.is_open(); }
    const FileDescriptor& descriptor() const { return descriptor_; }

    /// \return whether it is the file \p target now; errno says why not
    bool rename_to(const std::filesystem::path& target);

  private:
    std::filesystem::path path_;
    FileDescriptor descriptor_;
    bool renamed_ = false;
};

}  // namespace interleaf
