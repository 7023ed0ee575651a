#include "ui/browser/file_browser.h"

#include <algorithm>
#include <system_error>
#include <utility>

#include <fmt/core.h>

#include "text/characters.h"
#include "text/shown_text.h"
#include "ui/browser/typed_path.h"

namespace interleaf {

namespace {

namespace fs = std::filesystem;

/// \p folder as an absolute path, without "." and ".." and without a '/' at its end.
fs::path whole_path(const fs::path& folder) {
    std::error_code error;
    const fs::path path = fs::absolute(folder, error).lexically_normal();
    if (error) return "/";  // relative to a folder that no longer exists
    return path.has_filename() ? path : path.parent_path();
}

/// The nearest folder that exists: \p folder or one of its parents.
fs::path nearest_folder(fs::path folder) {
    std::error_code error;
    folder = whole_path(folder);
    while (!fs::is_directory(folder, error) && folder.has_relative_path()) folder = folder.parent_path();
    return folder;
}

bool ends_in_one_of(const fs::path& path, const std::vector<FileType>& types) {
    const std::string name = folded(path.filename().native());
    return std::ranges::any_of(types, [&](const FileType& type) {
        return std::ranges::any_of(
            type.extensions, [&](const std::string& extension) { return name.ends_with(folded(extension)); });
    });
}

std::string quoted(const fs::path& path) {
    return fmt::format("“{}”", shown_name(path.filename().native()));
}

}  // namespace

void FileBrowser::open(FileRequest request) {
    // Keep what the user has set for the next time: order, hidden files.
    request_ = std::move(request);
    open_ = is_new_ = true;
    choice_.reset();
    asked_ = Asked::nothing;
    type_ = 0;
    types_unfolded_ = false;
    part_ = is_saving() ? Part::field : Part::list;
    place_ = 0;
    column_ = order_.column;
    field_ = TextField();
    suggest_name();
    go_to(nearest_folder(request_.folder.empty() ? home_folder() : request_.folder));
}

bool FileBrowser::is_saving() const {
    return request_.purpose == FilePurpose::save || request_.purpose == FilePurpose::save_folder;
}

bool FileBrowser::wants_folder() const {
    return request_.purpose == FilePurpose::open_folder || request_.purpose == FilePurpose::save_folder;
}

bool FileBrowser::opens(const fs::path& folder) const {
    return request_.purpose == FilePurpose::open && request_.opens_folder && request_.opens_folder(folder);
}

FileType FileBrowser::type() const {
    return type_ < request_.types.size() ? request_.types[type_]
                                         : FileType{.name = "All files", .extensions = {}};
}

/// Puts the suggested name into the field, and selects it without its extension.
void FileBrowser::suggest_name() {
    if (is_saving()) field_.set(request_.name, fs::path(request_.name).stem().native().size());
}

void FileBrowser::complain(std::string text) {
    remark_ = std::move(text);
    field_.refocus();
}

/// \param cursor  name of the entry that gets the cursor
void FileBrowser::go_to(const fs::path& folder, const fs::path& cursor) {
    folder_ = whole_path(folder);
    listing_ = read_folder(folder_);
    remark_.clear();
    type_ahead_ = TypeAhead();
    crumb_ = static_cast<std::size_t>(std::ranges::distance(folder_)) - 1;
    arrange(cursor);
}

void FileBrowser::go_up() {
    if (folder_.has_relative_path()) go_to(folder_.parent_path(), folder_.filename());
}

void FileBrowser::read_again() {
    const FolderEntry* const entry = cursor_entry();
    go_to(folder_, entry != nullptr ? entry->name : fs::path());
}

/// Filters and sorts the entries again. Selects the entry named \p cursor, or nothing if it is not shown.
void FileBrowser::arrange(const fs::path& cursor) {
    shown_ = shown_entries(listing_.entries,
                           {.type = type(), .hidden = hidden_, .only_folders = wants_folder()}, order_);
    selection_.reset(shown_.size(), request_.several && request_.purpose == FilePurpose::open);
    const auto found =
        std::ranges::find(shown_, cursor, [&](std::size_t i) { return listing_.entries[i].name; });
    if (found != shown_.end() && !cursor.empty())
        selection_.step(static_cast<std::size_t>(found - shown_.begin()), SelectionStep::only);
    scroll_to_cursor_ = true;
}

const FolderEntry* FileBrowser::cursor_entry() const {
    return shown_.empty() ? nullptr : &listing_.entries[shown_[selection_.cursor()]];
}

std::optional<fs::path> FileBrowser::cursor_path() const {
    if (!open_) return std::nullopt;
    return shown_.empty() ? folder_ : path_of(selection_.cursor());
}

fs::path FileBrowser::path_of(std::size_t row) const {
    return folder_ / listing_.entries[shown_[row]].name;
}

/// What a double click and Enter do: opens the entry under the cursor, or all selected files.
void FileBrowser::activate_cursor() {
    const FolderEntry* const entry = cursor_entry();
    if (entry == nullptr) return;
    if (selection_.count() > 1) return accept_selection();
    if (entry->is_folder()) return go_to(folder_ / entry->name);
    selection_.step(selection_.cursor(), SelectionStep::only);
    if (is_saving()) return accept_name(path_of(selection_.cursor()));
    accept_selection();
}

void FileBrowser::accept() {
    const bool has_text = field_.text().find_first_not_of(' ') != std::string::npos;
    if (is_saving() || has_text) return accept_text();
    accept_selection();
}

void FileBrowser::accept_selection() {
    std::vector<fs::path> files;
    std::vector<fs::path> folders;
    for (const std::size_t row : selection_.rows()) {
        const bool is_folder = listing_.entries[shown_[row]].is_folder();
        (is_folder ? folders : files).push_back(path_of(row));
    }
    if (request_.purpose == FilePurpose::open_folder) {
        if (folders.empty()) folders.push_back(folder_);
        return choose(std::move(folders));
    }
    if (!files.empty()) return choose(std::move(files));
    if (folders.empty()) folders.push_back(folder_);
    if (folders.size() == 1 && opens(folders.front())) return choose(std::move(folders));
    if (folders.size() == 1 && folders.front() != folder_) return go_to(folders.front());
    complain(request_.several ? "Choose one or more files." : "Choose a file.");
}

void FileBrowser::accept_text() {
    const std::string text = field_.text();
    if (text.find_first_not_of(' ') == std::string::npos)
        return complain(is_saving() ? "Type a name." : "Type a path.");
    const fs::path path = typed_path(text, folder_, home_folder());
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    if (fs::is_directory(status) && opens(path)) return choose({path});
    if (fs::is_directory(status) && request_.purpose != FilePurpose::save_folder) {
        field_.set("");
        suggest_name();
        field_.refocus();
        return go_to(path);
    }
    if (is_saving()) return accept_name(path);
    if (wants_folder()) return complain(fmt::format("{} is not a folder.", quoted(path)));
    if (text.find('*') != std::string::npos && !fs::exists(status)) return choose({path});
    if (status.type() == fs::file_type::not_found)
        return complain(fmt::format("{} does not exist.", shown_name(path.native())));
    if (error) return complain(fmt::format("{}: {}", shown_name(path.native()), error.message()));
    choose({path});
}

/// Saves as \p path, unless something prevents it. Asks before it replaces anything.
void FileBrowser::accept_name(fs::path path) {
    const FileType chosen = type();
    if (request_.purpose == FilePurpose::save && !chosen.extensions.empty() &&
        !ends_in_one_of(path, request_.types))
        path += chosen.extensions.front();
    std::error_code error;
    if (!fs::is_directory(path.parent_path(), error))
        return complain(
            fmt::format("The folder {} does not exist.", shown_name(path.parent_path().native())));
    const fs::file_status status = fs::symlink_status(path, error);
    if (error && status.type() != fs::file_type::not_found)
        return complain(fmt::format("{}: {}", quoted(path), error.message()));
    if (!fs::exists(status)) return choose({path});

    const bool is_folder = fs::is_directory(path, error);
    if (wants_folder() && !is_folder) return complain(fmt::format("{} is a file.", quoted(path)));
    if (!wants_folder() && is_folder) return complain(fmt::format("{} is a folder.", quoted(path)));
    if (is_folder && fs::is_empty(path, error)) return choose({path});
    path_to_replace_ = path;
    asked_ = Asked::replace;
    const std::string detail = is_folder ? "A family in it will be replaced. Other files will stay."
                                         : "Its current content will be lost.";
    dialog_.ask({.text = fmt::format("{} already exists. Replace it?", quoted(path)),
                 .detail = detail,
                 .buttons = {"Replace", "Cancel"},
                 .default_button = 1,
                 .entry = std::nullopt,
                 .fault = nullptr});
}

void FileBrowser::choose(std::vector<fs::path> files) {
    choice_ = FileChoice{.files = std::move(files), .folder = folder_};
    open_ = false;
}

void FileBrowser::ask_for_new_folder() {
    asked_ = Asked::new_folder;
    const auto fault = [this](const std::string& name) -> std::string {
        if (name.find_first_not_of(" .") == std::string::npos) return "Enter a name.";
        if (name.find('/') != std::string::npos) return "A name cannot contain “/”.";
        std::error_code error;
        return fs::exists(fs::symlink_status(folder_ / name, error)) ? "This name already exists." : "";
    };
    dialog_.ask({.text = "New folder",
                 .detail = fmt::format("in {}", shown_name(folder_.native())),
                 .buttons = {"Create", "Cancel"},
                 .default_button = 0,
                 .entry = "New folder",
                 .fault = fault});
}

void FileBrowser::take_answer(const Answer& answer) {
    const Asked asked = std::exchange(asked_, Asked::nothing);
    if (answer.button != 0) return field_.refocus();
    if (asked == Asked::replace) return choose({path_to_replace_});
    std::error_code error;
    fs::create_directory(folder_ / answer.entry, error);
    if (error) return complain(fmt::format("Cannot create “{}”: {}", answer.entry, error.message()));
    go_to(folder_ / answer.entry);
}

}  // namespace interleaf
