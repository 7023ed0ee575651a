#include "app/document/opening.h"

#include <algorithm>
#include <utility>

#include <fmt/core.h>

#include "app/document/builtin_family.h"
#include "app/importing/series_import.h"
#include "hierarchy/error.h"
#include "io/family/family_file.h"
#include "io/file/file_pattern.h"
#include "io/formats.h"
#include "io/read_files.h"

namespace interleaf {

namespace {

/// The files in \p folder whose formats have this trait.
std::vector<std::filesystem::path> files_called(const std::filesystem::path& folder, FormatTrait trait) {
    std::vector<std::filesystem::path> files;
    std::error_code error;
    std::filesystem::directory_iterator entry(folder, error);
    for (; !error && entry != std::filesystem::directory_iterator(); entry.increment(error)) {
        std::error_code ignored;
        const std::filesystem::path& file = entry->path();
        const bool is_hidden = file.filename().native().starts_with('.');
        if (!is_hidden && is_called(file, trait) && entry->is_regular_file(ignored)) files.push_back(file);
    }
    sort_naturally(files);
    return files;
}

bool are_called(std::span<const std::filesystem::path> files, FormatTrait trait) {
    return std::ranges::all_of(files,
                               [trait](const std::filesystem::path& file) { return is_called(file, trait); });
}

/// Whether at least one of these meshes has a format that holds no keys.
bool must_be_fitted(std::span<const std::filesystem::path> files) {
    return are_called(files, &Format::holds_mesh) && !are_called(files, &Format::holds_key);
}

Opening open_keys(std::vector<std::filesystem::path> files) {
    std::vector<std::string> changes;
    auto read = read_keys_if_fitting(files, &changes);
    if (auto* family = std::get_if<Family>(&read)) {
        if (family->timeline && files.size() > 1 && is_numbered_series(files))
            family->timeline = family->timeline->with_unit(TimeUnit::steps);
        return OpenedKeys{std::move(*family), std::move(changes), std::move(files)};
    }
    std::string reason = std::move(std::get<Misfit>(read).reason);
    if (files.size() < 2 || !are_called(files, &Format::holds_mesh)) throw InputError(reason);
    return MeshesToFit{std::move(files), std::move(reason)};
}

/// The reason why \p meshes are not a family, for a command that does not fit meshes.
std::string fault_of(const MeshesToFit& meshes) {
    if (!meshes.reason.empty()) return meshes.reason;
    if (meshes.files.size() == 1)
        return fmt::format("{}: expected a folder, or a file that ends in {}", meshes.files.front().string(),
                           extensions_in_words(&Format::holds_family_or_key));
    const auto mesh = std::ranges::find_if(
        meshes.files, [](const std::filesystem::path& file) { return !is_called(file, &Format::holds_key); });
    return fmt::format("{}: expected a file that ends in {}; `interleaf fit` makes keys of other meshes",
                       mesh->string(), extensions_in_words(&Format::holds_key));
}

}  // namespace

bool OpenedKeys::can_be_fitted() const {
    return are_called(files, &Format::holds_mesh);
}

bool is_family_folder(const std::filesystem::path& path) {
    std::error_code ignored;
    const std::filesystem::file_status file = std::filesystem::status(path / "family.json", ignored);
    return std::filesystem::exists(file) && !std::filesystem::is_directory(file);
}

std::vector<std::filesystem::path> files_in_folder(const std::filesystem::path& path) {
    std::error_code ignored;
    if (!std::filesystem::is_directory(path, ignored) || is_family_folder(path)) return {};
    std::vector<std::filesystem::path> keys = files_called(path, &Format::holds_key_alone);
    return keys.empty() ? files_called(path, &Format::holds_mesh) : keys;
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

Opening open_files(std::span<const std::filesystem::path> paths, const Progress& progress) {
    OpenedFamily opened;
    if (paths.empty()) {
        opened.family = read_family(builtin_family_folder(), &opened.changes, progress);
        return opened;
    }
    std::vector<std::filesystem::path> files = files_of(paths);
    if (are_called(files, &Format::holds_series)) return SeriesToImport{std::move(files)};
    if (must_be_fitted(files)) return MeshesToFit{std::move(files), ""};
    if (files.size() > 1) return open_keys(std::move(files));

    const std::filesystem::path& file = files.front();
    std::error_code ignored;
    if (std::filesystem::is_directory(file, ignored) || file.filename() == "family.json") {
        opened.family = read_family(file, &opened.changes, progress);
        return opened;
    }
    const Format* const format = find_format(file);
    if (format == nullptr)
        throw InputError(fmt::format("{}: expected a folder, or a file that ends in {}", file.string(),
                                     extensions_in_words(&Format::holds_family_or_key)));
    if (!format->holds_family()) return open_keys(std::move(files));
    opened.family = format->read_family(file, &opened.changes);
    // The file is no place to save to, and its mesh can also be fitted.
    if (format->holds_mesh())
        return OpenedKeys{std::move(opened.family), std::move(opened.changes), std::move(files)};
    return opened;
}

OpenedKeys import_steps(const SeriesToImport& series) {
    ImportedSeries imported =
        import_series(series_files(series.files), series_name(series.files.front()), {}, {});
    return {std::move(imported.family), std::move(imported.report.notes), series.files};
}

Family family_of(Opening opened, std::vector<std::string>* changes) {
    const auto taken = [changes](auto& read) {
        if (changes != nullptr) changes->insert(changes->end(), read.changes.begin(), read.changes.end());
        return std::move(read.family);
    };
    return std::visit(Cases{[&](OpenedFamily& family) { return taken(family); },
                            [&](OpenedKeys& keys) { return taken(keys); },
                            [](const MeshesToFit& meshes) -> Family { throw InputError(fault_of(meshes)); },
                            [&](const SeriesToImport& series) {
                                OpenedKeys keys = import_steps(series);
                                return taken(keys);
                            }},
                      opened);
}

Family open_family(std::span<const std::filesystem::path> paths, std::vector<std::string>* changes) {
    return family_of(open_files(paths), changes);
}

}  // namespace interleaf
