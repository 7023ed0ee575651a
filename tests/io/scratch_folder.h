// A folder for the files of one test, removed at its end, and what tests do with files in it.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

namespace interleaf {

class ScratchFolder {
  public:
    explicit ScratchFolder(const std::filesystem::path& parent = std::filesystem::temp_directory_path());
    ScratchFolder(const ScratchFolder&) = delete;
    ScratchFolder& operator=(const ScratchFolder&) = delete;
    ~ScratchFolder();

    std::filesystem::path operator/(std::string_view name) const { return path_ / name; }
    const std::filesystem::path& path() const { return path_; }

    /// Number of files, folders and links directly in it.
    std::size_t entry_count() const;

  private:
    std::filesystem::path path_;
};

/// A folder in memory, where flushing takes no time; the one for temporary files where there is none.
std::filesystem::path memory_folder();

std::string content(const std::filesystem::path& file);

/// Writes without safe_write.h, whose tests must not rest on it.
void put(const std::filesystem::path& file, std::string_view text);

/// The text of the InputError or MachineError that \p action throws; "" if it throws nothing.
std::string input_error_of(const std::function<void()>& action);
std::string machine_error_of(const std::function<void()>& action);

}  // namespace interleaf
