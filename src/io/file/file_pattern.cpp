#include "io/file/file_pattern.h"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <system_error>

#include <fmt/core.h>

#include "hierarchy/error.h"
#include "text/natural_order.h"

namespace interleaf {

namespace {

namespace fs = std::filesystem;

/// Whether \p name matches \p pattern, in which an asterisk stands for any characters.
bool matches(std::string_view name, std::string_view pattern) {
    if (name.starts_with('.') && !pattern.starts_with('.')) return false;
    // If the text after the last asterisk does not match, that asterisk takes one more character. Earlier
    // asterisks need no more characters.
    std::size_t n = 0, p = 0, asterisk = std::string_view::npos, taken_to = 0;
    while (n < name.size()) {
        if (p < pattern.size() && pattern[p] == '*') {
            asterisk = p++;
            taken_to = n;
        } else if (p < pattern.size() && pattern[p] == name[n]) {
            ++n;
            ++p;
        } else if (asterisk != std::string_view::npos) {
            p = asterisk + 1;
            n = ++taken_to;
        } else {
            return false;
        }
    }
    return pattern.find_first_not_of('*', p) == std::string_view::npos;
}

}  // namespace

bool is_numbered_series(const std::vector<fs::path>& files) {
    if (files.empty()) return false;
    const std::string first = without_numbers(files.front().string());
    return std::ranges::all_of(files,
                               [&](const fs::path& file) { return without_numbers(file.string()) == first; });
}

void sort_naturally(std::vector<fs::path>& files) {
    std::vector<NaturalName> names;
    names.reserve(files.size());
    for (const fs::path& file : files) names.emplace_back(file.string());
    std::ranges::sort(names);
    std::ranges::transform(names, files.begin(), &NaturalName::text);
}

std::vector<fs::path> matching_files(const fs::path& path) {
    const std::string whole = path.string();
    std::error_code error;
    if (whole.find('*') == std::string::npos || fs::exists(path, error)) return {path};
    if (path.parent_path().string().find('*') != std::string::npos)
        throw InputError(
            fmt::format("{}: expected * only in the name of the file, not in its folder", whole));

    const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
    std::vector<fs::path> files;
    fs::directory_iterator entry(folder, error);
    if (error == std::errc::no_such_file_or_directory || error == std::errc::not_a_directory)
        throw InputError(fmt::format("{}: there is no such folder", folder.string()));
    for (; !error && entry != fs::directory_iterator(); entry.increment(error)) {
        const fs::path name = entry->path().filename();
        std::error_code ignored;
        if (matches(name.string(), path.filename().string()) && entry->is_regular_file(ignored))
            files.push_back(path.has_parent_path() ? path.parent_path() / name : name);
    }
    if (error) throw MachineError(fmt::format("{}: cannot be read: {}", folder.string(), error.message()));
    if (files.empty()) throw InputError(fmt::format("{}: no file matches", whole));
    sort_naturally(files);
    return files;
}

fs::path path_of_all(const std::vector<fs::path>& files) {
    const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
    const std::string first = files.front().filename().string();
    std::size_t begin = first.size(), end = first.size();  // lengths of what all names begin and end with
    for (const fs::path& file : files) {
        const std::string name = file.filename().string();
        begin =
            std::min(begin, static_cast<std::size_t>(std::ranges::mismatch(first, name).in1 - first.begin()));
        const auto backward = std::mismatch(first.rbegin(), first.rend(), name.rbegin(), name.rend());
        end = std::min(end, static_cast<std::size_t>(backward.first - first.rbegin()));
    }
    while (begin > 0 && is_digit(first[begin - 1])) --begin;
    while (end > 0 && is_digit(first[first.size() - end])) --end;
    if (files.size() == 1 || begin + end > first.size()) return files.front();
    const fs::path pattern =
        files.front().parent_path() / (first.substr(0, begin) + "*" + first.substr(first.size() - end));
    try {
        return matching_files(pattern) == files ? pattern : files.front();
    } catch (const std::runtime_error&) {
        return files.front();  // another folder has an asterisk
    }
}

std::string lower_case_extension(const std::filesystem::path& file) {
    std::string extension = file.extension().string();
    for (char& c : extension)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return extension;
}

}  // namespace interleaf
