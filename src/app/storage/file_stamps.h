// Detects files that other programs have changed since they were read.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

namespace interleaf {

class FileStamps {
  public:
    FileStamps() = default;

    /// Records the present stamps of \p files.
    explicit FileStamps(const std::vector<std::filesystem::path>& files);

    /// The first file that has changed or disappeared; each change is reported once.
    std::optional<std::filesystem::path> take_changed();

  private:
    struct Stamp {
        std::filesystem::path file;
        std::filesystem::file_time_type written{};  ///< the default if there is no file
        std::uintmax_t size = 0;
        bool operator==(const Stamp&) const = default;
    };
    static Stamp stamp_of(const std::filesystem::path& file);

    std::vector<Stamp> stamps_;
};

}  // namespace interleaf
