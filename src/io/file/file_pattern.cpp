#include "io/file/file_pattern.h"

#include <algorithm>
#include <string>
#include <system_error>

#include <fmt/core.h>

#include "hierarchy/error.h"

namespace interleaf {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view digits = "0123456789";

/// The run of digits, or the one other character, that \p text begins with; taken off it.
std::string_view take_part(std::string_view& text) {
    const std::size_t run = std::min(text.find_first_not_of(digits), text.size());
    const std::string_view part = text.substr(0, std::max<std::size_t>(run, 1));
    text.remove_prefix(part.size());
    return part;
}

bool is_number(std::string_view part) {
    return digits.find(part.front()) != std::string_view::npos;
}

std::string_view without_zeros(std::string_view number) {
    return number.substr(std::min(number.find_first_not_of('0'), number.size()));
}

/// Negative, 0 or positive as \p a is less than, equal to or greater than \p b.
int compare_parts(std::string_view a, std::string_view b) {
    if (!is_number(a) || !is_number(b)) return a.compare(b);
    a = without_zeros(a);
    b = without_zeros(b);
    if (a.size() != b.size()) return a.size() < b.size() ? -1 : 1;
    return a.compare(b);
}

/// \p text with each number replaced by one 0.
std::string without_numbers(std::string_view text) {
    std::string result;
    while (!text.empty()) {
        const std::string_view part = take_part(text);
        result += is_number(part) ? "0" : part;
    }
    return result;
}

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

bool is_before_naturally(std::string_view a, std::string_view b) {
    const std::string_view whole_a = a, whole_b = b;
    while (!a.empty() && !b.empty())
        if (const int order = compare_parts(take_part(a), take_part(b)); order != 0) return order < 0;
    if (a.empty() != b.empty()) return a.empty();
    return whole_a < whole_b;
}

bool is_numbered_series(const std::vector<fs::path>& files) {
    if (files.empty()) return false;
    const std::string first = without_numbers(files.front().string());
    return std::ranges::all_of(files,
                               [&](const fs::path& file) { return without_numbers(file.string()) == first; });
}

void sort_naturally(std::vector<fs::path>& files) {
    std::ranges::sort(files, [](const fs::path& a, const fs::path& b) {
        return is_before_naturally(a.string(), b.string());
    });
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

std::string lower_case_extension(const std::filesystem::path& file) {
    std::string extension = file.extension().string();
    for (char& c : extension)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return extension;
}

}  // namespace interleaf
