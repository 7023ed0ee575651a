#include "app/document/open_family.h"

#include <algorithm>
#include <initializer_list>
#include <string_view>

#include <fmt/core.h>

#include "app/document/builtin_family.h"
#include "hierarchy/error.h"
#include "io/family/family_file.h"
#include "io/file/file_pattern.h"

namespace interleaf {

namespace {

/// The files in \p folder whose names end in one of \p extensions.
std::vector<std::filesystem::path> files_ending(const std::filesystem::path& folder,
                                                std::initializer_list<std::string_view> extensions) {
    std::vector<std::filesystem::path> files;
    std::error_code error;
    std::filesystem::directory_iterator entry(folder, error);
    for (; !error && entry != std::filesystem::directory_iterator(); entry.increment(error)) {
        std::error_code ignored;
        const std::filesystem::path& file = entry->path();
        const bool is_hidden = file.filename().native().starts_with('.');
        if (!is_hidden && std::ranges::find(extensions, lower_case_extension(file)) != extensions.end() &&
            entry->is_regular_file(ignored))
            files.push_back(file);
    }
    sort_naturally(files);
    return files;
}

}  // namespace

bool is_family_folder(const std::filesystem::path& path) {
    std::error_code ignored;
    const std::filesystem::file_status file = std::filesystem::status(path / "family.json", ignored);
    return std::filesystem::exists(file) && !std::filesystem::is_directory(file);
}

std::vector<std::filesystem::path> files_in_folder(const std::filesystem::path& path) {
    std::error_code ignored;
    if (!std::filesystem::is_directory(path, ignored) || is_family_folder(path)) return {};
    std::vector<std::filesystem::path> keys = files_ending(path, {".ilh"});
    return keys.empty() ? files_ending(path, {".obj", ".ply", ".stl", ".off"}) : keys;
}

std::vector<std::filesystem::path> files_of(std::span<const std::filesystem::path> paths) {
    std::vector<std::filesystem::path> files;
    for (const std::filesystem::path& path : paths) {
        for (const std::filesystem::path& matching : matching_files(path)) {
            const std::vector<std::filesystem::path> inside = files_in_folder(matching);
            if (inside.empty()) files.push_back(matching);
            files.insert(files.end(), inside.begin(), inside.end());
        }
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
