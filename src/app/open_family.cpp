#include "app/open_family.h"

#include <fmt/core.h>

#include "app/builtin_family.h"
#include "hierarchy/error.h"
#include "io/family_file.h"
#include "io/file_pattern.h"

namespace interleaf {

std::vector<std::filesystem::path> files_of(std::span<const std::filesystem::path> paths) {
    std::vector<std::filesystem::path> files;
    for (const std::filesystem::path& path : paths) {
        const std::vector<std::filesystem::path> matching = matching_files(path);
        files.insert(files.end(), matching.begin(), matching.end());
    }
    if (is_numbered_series(files)) sort_naturally(files);
    for (const std::filesystem::path& file : files) {
        std::error_code error;
        if (std::filesystem::status(file, error).type() == std::filesystem::file_type::not_found)
            throw InputError(fmt::format("{}: there is no such file", file.string()));
    }
    return files;
}

Family open_family(std::span<const std::filesystem::path> paths, std::vector<std::string>* changes) {
    if (paths.empty()) return read_family(builtin_family_folder(), changes);
    const std::vector<std::filesystem::path> files = files_of(paths);
    return files.size() == 1 ? read_family(files.front(), changes) : read_keys(files, changes);
}

}  // namespace interleaf
