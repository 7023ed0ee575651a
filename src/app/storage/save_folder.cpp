#include "app/storage/save_folder.h"

#include <algorithm>
#include <system_error>

#include "app/document/opening.h"

namespace interleaf {

namespace {

namespace fs = std::filesystem;

fs::path resolved(const fs::path& path) {
    std::error_code error;
    fs::path real = fs::weakly_canonical(path, error);
    return error ? path.lexically_normal() : real;
}

bool is_within(const fs::path& path, const fs::path& folder) {
    if (folder.empty()) return false;
    const fs::path inner = resolved(path);
    const fs::path outer = resolved(folder);
    return std::ranges::mismatch(outer, inner).in1 == outer.end();
}

}  // namespace

fs::path folder_to_save_in(const SaveSurroundings& around) {
    const auto is_fit = [&](const fs::path& folder) {
        return !folder.empty() && folder.has_relative_path() && !is_within(folder, around.builtin);
    };
    if (around.document && is_fit(*around.document)) return around.document->parent_path();
    for (const fs::path& folder : {around.last, around.current})
        if (is_fit(folder)) return is_family_folder(folder) ? folder.parent_path() : folder;
    return {};
}

std::string folder_name(std::string name) {
    std::ranges::replace_if(
        name, [](char c) { return c == '/' || c == '\0'; }, '-');
    return name.empty() ? "family" : name;
}

}  // namespace interleaf
