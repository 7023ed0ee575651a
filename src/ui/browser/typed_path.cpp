#include "ui/browser/typed_path.h"

#include <algorithm>
#include <cstdlib>
#include <system_error>
#include <vector>

#include "text/characters.h"
#include "ui/widgets/text_field.h"

namespace interleaf {

namespace {

namespace fs = std::filesystem;

/// \p text without blanks and one pair of quotes around it.
std::string_view bare(std::string_view text) {
    text = without_blanks(text);
    const bool quoted =
        text.size() >= 2 && (text.front() == '"' || text.front() == '\'') && text.back() == text.front();
    return quoted ? text.substr(1, text.size() - 2) : text;
}

/// The names in \p folder that begin with \p beginning. \p fold ignores case.
std::vector<std::string> names_beginning(const fs::path& folder, std::string_view beginning, bool fold) {
    const std::string wanted = fold ? folded(beginning) : std::string(beginning);
    std::vector<std::string> names;
    std::error_code error;
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
        std::string name = entry->path().filename().string();
        if (name.starts_with('.') && !beginning.starts_with('.')) continue;
        if (!is_editable(name)) continue;
        if ((fold ? folded(name) : name).starts_with(wanted)) names.push_back(std::move(name));
    }
    return names;
}

/// The longest common beginning of \p names, cut between characters.
std::string common_beginning(const std::vector<std::string>& names) {
    std::string_view common = names.front();
    for (const std::string& name : names) {
        const auto difference = std::ranges::mismatch(common, name).in1;
        common = common.substr(0, static_cast<std::size_t>(difference - common.begin()));
    }
    std::size_t size = common.size();
    const std::string& name = names.front();
    while (size > 0 && size < name.size() && continues_character(name[size])) --size;
    return std::string(common.substr(0, size));
}

}  // namespace

fs::path home_folder() {
    const char* const home = std::getenv("HOME");
    return home != nullptr && fs::path(home).is_absolute() ? fs::path(home) : fs::path("/");
}

fs::path typed_path(std::string_view text, const fs::path& folder, const fs::path& home) {
    text = bare(text);
    if (text == "~") return home;
    fs::path path = text.starts_with("~/") ? home / text.substr(2) : folder / text;
    path = path.lexically_normal();
    return path.has_filename() || path == path.root_path() ? path : path.parent_path();
}

PathCompletion completed_path(std::string_view text, const fs::path& folder, const fs::path& home) {
    if (text == "~") return {.text = "~/", .names = 1};
    const std::size_t slash = text.rfind('/');
    const std::size_t begin = slash == std::string_view::npos ? 0 : slash + 1;
    const std::string_view before = text.substr(0, begin);
    const std::string_view typed = text.substr(begin);
    const fs::path in = before.empty() ? folder : typed_path(before, folder, home);

    PathCompletion completion{.text = std::string(text), .names = 0};
    std::vector<std::string> names = names_beginning(in, typed, false);
    if (names.empty()) names = names_beginning(in, typed, true);
    completion.names = names.size();
    if (names.empty()) return completion;
    std::string completed = common_beginning(names);
    std::error_code ignored;
    if (names.size() == 1 && fs::is_directory(in / completed, ignored)) completed += '/';
    // Names that differ in case may have less in common than the typed text.
    if (completed.size() >= typed.size()) completion.text = std::string(before) + completed;
    return completion;
}

}  // namespace interleaf
