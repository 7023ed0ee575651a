// Keeps others from saving a family into the same folder at the same time: two that choose file names, and
// remove files, by turns would mix their families up. The system takes the lock off when the process ends,
// however it ends.
#pragma once

#include <filesystem>

#include "io/file/file_descriptor.h"

namespace interleaf {

class FolderLock {
  public:
    /// Waits until nobody else holds it. File systems without locks do without.
    /// \throw MachineError naming \p folder if somebody holds it for ten seconds, or it cannot be opened
    explicit FolderLock(const std::filesystem::path& folder);

  private:
    FileDescriptor descriptor_;
};

}  // namespace interleaf
