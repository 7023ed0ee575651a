// A lock that keeps two processes from saving a family into the same folder at the same time. Without it,
// both would choose file names and remove files in turn, and mix up their families. The system releases the
// lock when the process ends, however it ends.
#pragma once

#include <filesystem>

#include "io/file/file_descriptor.h"

namespace interleaf {

class FolderLock {
  public:
    /// Waits until no other process holds the lock. Does nothing on file systems without locks.
    /// \throw MachineError naming \p folder if another process holds the lock for ten seconds, or if the
    ///                     folder cannot be opened
    explicit FolderLock(const std::filesystem::path& folder);

  private:
    FileDescriptor descriptor_;
};

}  // namespace interleaf
