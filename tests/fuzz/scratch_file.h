// A file for readers that do not read from memory, in a folder that is deleted when the program ends.
#pragma once

#include <filesystem>
#include <string_view>

#include "fuzz/target.h"

namespace interleaf::fuzz {

class ScratchFile {
  public:
    explicit ScratchFile(std::string_view name);
    ScratchFile(const ScratchFile&) = delete;
    ScratchFile& operator=(const ScratchFile&) = delete;
    ~ScratchFile();

    const std::filesystem::path& path() const { return path_; }
    std::filesystem::path folder() const { return path_.parent_path(); }
    void set_content(ByteSpan bytes) const;

  private:
    std::filesystem::path path_;
};

}  // namespace interleaf::fuzz
