#include "io/read_files.h"

#include <algorithm>
#include <utility>

#include <fmt/core.h>

#include "hierarchy/error.h"
#include "io/family/family_file.h"
#include "io/family/family_format.h"
#include "io/formats.h"

namespace interleaf {
namespace {

namespace fs = std::filesystem;

const Format& key_format_of(const fs::path& file) {
    if (!is_called(file, &Format::holds_key))
        throw InputError(
            fmt::format("{}: expected a file that ends in {}; `interleaf fit` makes keys of other meshes",
                        file.string(), extensions_in_words(&Format::holds_key)));
    return *find_format(file);
}

/// Reads files of more than one format, one by one.
std::variant<FileKeys, Misfit> read_mixture(std::span<const fs::path> files) {
    FileKeys all;
    std::size_t number = 0;
    for (const fs::path& file : files) {
        auto read = key_format_of(file).read_keys(std::span(&file, 1), all.origin);
        if (auto* misfit = std::get_if<Misfit>(&read)) return std::move(*misfit);
        append_keys(all, std::get<FileKeys>(std::move(read)),
                    {family_format::utf8_of(file.stem()), number++});
    }
    return all;
}

std::variant<FileKeys, Misfit> read_all(std::span<const fs::path> files) {
    const Format* const format = find_format(files.front());
    const bool is_mixture =
        std::ranges::any_of(files, [&](const fs::path& file) { return find_format(file) != format; });
    return is_mixture ? read_mixture(files) : key_format_of(files.front()).read_keys(files, std::nullopt);
}

}  // namespace

std::variant<Family, Misfit> read_keys_if_fitting(std::span<const fs::path> files,
                                                  std::vector<std::string>* changes) {
    auto read = read_all(files);
    if (auto* misfit = std::get_if<Misfit>(&read)) return std::move(*misfit);
    return family_of_files(files, std::get<FileKeys>(std::move(read)), changes);
}

Family read_keys(std::span<const fs::path> files, std::vector<std::string>* changes) {
    auto read = read_keys_if_fitting(files, changes);
    if (const auto* misfit = std::get_if<Misfit>(&read)) throw InputError(misfit->reason);
    return std::get<Family>(std::move(read));
}

SurfaceFile read_surface(const fs::path& file) {
    if (!is_called(file, &Format::holds_mesh))
        throw InputError(fmt::format("{}: expected a file that ends in {}", file.string(),
                                     extensions_in_words(&Format::holds_mesh)));
    return parse_file(file, find_format(file)->parse_surface);
}

}  // namespace interleaf
