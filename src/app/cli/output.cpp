#include "app/cli/output.h"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>

#include <fmt/core.h>

#include "hierarchy/error.h"
#include "io/file/safe_write.h"

namespace interleaf {

std::string_view format_of(const Output& output, std::span<const std::string_view> known) {
    if (output.format.empty() && output.target == "-")
        throw UsageError("-o -: standard output needs --format");
    const std::string extension = std::filesystem::path(output.target).extension().string();
    std::string_view name = output.format.empty() ? extension : output.format;
    if (name.starts_with('.')) name.remove_prefix(1);

    const auto found = std::ranges::find(known, name);
    if (found != known.end()) return *found;
    std::string names;
    for (const std::string_view each : known) names.append(names.empty() ? "" : ", ").append(each);
    throw UsageError(fmt::format("{}: expected the format {}, got '{}'", output.target, names, name));
}

void write_output(const Output& output, std::span<const std::byte> bytes) {
    if (output.target != "-") {
        write_file(output.target, bytes);
    } else if (std::fwrite(bytes.data(), 1, bytes.size(), stdout) != bytes.size() ||
               std::fflush(stdout) != 0) {
        throw MachineError(fmt::format("standard output: {}", std::strerror(errno)));
    }
}

void write_output(const Output& output, std::string_view text) {
    write_output(output, std::as_bytes(std::span(text)));
}

}  // namespace interleaf
