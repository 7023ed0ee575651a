// A folder that is there as long as the test that uses it, and the content of files in it.
#pragma once

#include <filesystem>
#include <string>

namespace interleaf {

class TemporaryFolder {
  public:
    TemporaryFolder();
    ~TemporaryFolder();
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    const std::filesystem::path& path() const { return path_; }

    /// The path of \p name in the folder, as a word of a command line.
    std::string operator/(const std::string& name) const { return (path_ / name).string(); }

  private:
    std::filesystem::path path_;
};

std::string content_of(const std::filesystem::path& file);

void set_content(const std::filesystem::path& file, const std::string& content);

}  // namespace interleaf
