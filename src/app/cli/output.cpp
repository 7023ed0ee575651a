#include "app/cli/output.h"

#include <algorithm>
#include <filesystem>

#include <fmt/core.h>

#include "hierarchy/error.h"
#include "io/text/joined_text.h"

namespace interleaf {

std::string format_of(const Output& output, std::span<const std::string> known) {
    if (output.format.empty() && output.target == "-")
        throw UsageError("-o -: standard output needs --format");
    const std::string extension = std::filesystem::path(output.target).extension().string();
    std::string name = output.format.empty() ? extension : output.format;
    if (name.starts_with('.')) name.erase(0, 1);
    if (std::ranges::find(known, name) == known.end())
        throw UsageError(
            fmt::format("{}: expected the format {}, got '{}'", output.target, joined(known, ", "), name));
    return name;
}

std::vector<std::string> format_names(FormatTrait trait) {
    std::vector<std::string> names = extensions_of(trait);
    for (std::string& name : names) name.erase(0, 1);
    return names;
}

OutputTarget target_of(const Output& output) {
    return {output.target == "-" ? std::filesystem::path() : std::filesystem::path(output.target)};
}

OutputTarget key_target_of(const std::string& target) {
    const std::vector<std::string> known = format_names(&Format::is_exported_key);
    const Output output{target, target == "-" ? known.front() : ""};
    format_of(output, known);
    return target_of(output);
}

std::string family_name_for(const std::filesystem::path& folder) {
    const std::filesystem::path whole = folder.has_filename() ? folder : folder.parent_path();
    const std::string name = std::filesystem::absolute(whole).lexically_normal().filename().string();
    return name.empty() || name == "." ? "family" : name;
}

}  // namespace interleaf
