// A file for readers that do not read from memory, in a folder that is deleted when the program ends.
#pragma once

#include <filesystem>
#include <string_view>

#include "fuzz/target.h"
#include "scratch_folder.h"

namespace interleaf::fuzz {

class ScratchFile {
  public:
    explicit ScratchFile(std::string_view name);

    const std::filesystem::path& path() const { return path_; }
    const std::filesystem::path& folder() const { return folder_.path(); }
    void set_content(ByteSpan bytes) const;

  private:
    ScratchFolder folder_;
    std::filesystem::path path_;
};

}  // namespace interleaf::fuzz
