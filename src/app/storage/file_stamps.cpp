#include "app/storage/file_stamps.h"

#include <system_error>
#include <utility>

namespace interleaf {

FileStamps::FileStamps(const std::vector<std::filesystem::path>& files) {
    for (const std::filesystem::path& file : files) stamps_.push_back(stamp_of(file));
}

FileStamps::Stamp FileStamps::stamp_of(const std::filesystem::path& file) {
    Stamp stamp{.file = file};
    std::error_code error;
    const auto written = std::filesystem::last_write_time(file, error);
    if (!error) stamp.written = written;
    const std::uintmax_t size = std::filesystem::file_size(file, error);
    if (!error) stamp.size = size;
    return stamp;
}

std::optional<std::filesystem::path> FileStamps::take_changed() {
    for (Stamp& stamp : stamps_) {
        Stamp present = stamp_of(stamp.file);
        if (present == stamp) continue;
        stamp = std::move(present);
        return stamp.file;
    }
    return std::nullopt;
}

}  // namespace interleaf
