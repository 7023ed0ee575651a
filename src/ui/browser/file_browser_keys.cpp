// The keyboard of the file browser.
#define GLFW_INCLUDE_NONE

#include <algorithm>
#include <array>

#include <GLFW/glfw3.h>
#include <imgui.h>

#include "text/shown_text.h"
#include "ui/browser/breadcrumbs.h"
#include "ui/browser/file_browser.h"
#include "ui/browser/typed_path.h"
#include "ui/widgets/modal.h"

namespace interleaf {

std::vector<FilePlace> FileBrowser::all_places() const {
    std::vector<FilePlace> places{{.name = "Home", .folder = home_folder()}};
    places.insert(places.end(), request_.places.begin(), request_.places.end());
    for (const std::filesystem::path& folder : request_.recent_folders) {
        const std::string name = folder.has_filename() ? folder.filename().native() : folder.native();
        places.push_back({.name = shown_name(name), .folder = folder});
    }
    return places;
}

void FileBrowser::read_keys() {
    if (types_unfolded_) return;
    const ImGuiIO& io = ImGui::GetIO();
    if (is_key_pressed(GLFW_KEY_ESCAPE)) open_ = false;
    if (is_key_pressed(GLFW_KEY_F5)) read_again();
    if (io.KeyCtrl && is_key_pressed(GLFW_KEY_H)) toggle_hidden();
    if (io.KeyCtrl && is_key_pressed(GLFW_KEY_L)) part_ = Part::field;
    if (io.KeyCtrl && io.KeyShift && is_key_pressed(GLFW_KEY_N) && is_saving()) return ask_for_new_folder();
    if (io.KeyCtrl && is_enter_pressed()) return accept();
    if (io.KeyAlt && is_key_pressed(GLFW_KEY_UP)) return go_up();
    if (io.KeyAlt && is_key_pressed(GLFW_KEY_HOME)) return go_to(home_folder());
    // Tab may complete the path in the field; the field reports whether it did.
    if (is_key_pressed(GLFW_KEY_TAB, KeyRepeat::yes) && (part_ != Part::field || io.KeyShift))
        move_part(io.KeyShift ? -1 : 1);
    else if (part_ == Part::list)
        read_list_keys();
    else if (part_ != Part::field)
        read_part_keys();
}

bool FileBrowser::is_shown(Part part) const {
    switch (part) {
        case Part::type:
            return !wants_folder() && !request_.types.empty();
        case Part::new_folder:
            return is_saving() && !is_narrow_;
        case Part::places:
            return has_places_;
        default:
            return true;
    }
}

void FileBrowser::move_part(int by) {
    constexpr int parts = static_cast<int>(Part::headings) + 1;
    int part = static_cast<int>(part_);
    do {
        part = (part + by + parts) % parts;
    } while (!is_shown(static_cast<Part>(part)));
    part_ = static_cast<Part>(part);
}

void FileBrowser::move_cursor(std::ptrdiff_t by) {
    if (shown_.empty()) return;
    const ImGuiIO& io = ImGui::GetIO();
    const auto last = static_cast<std::ptrdiff_t>(shown_.size()) - 1;
    auto row = static_cast<std::ptrdiff_t>(selection_.cursor());
    // The first arrow key only shows the cursor.
    const bool is_first = selection_.count() == 0 && row == 0 && (by == 1 || by == -1) && !io.KeyCtrl;
    if (!is_first) row = std::clamp(row + by, std::ptrdiff_t{0}, last);
    const SelectionStep step = io.KeyShift  ? SelectionStep::extend
                               : io.KeyCtrl ? SelectionStep::look
                                            : SelectionStep::only;
    selection_.step(static_cast<std::size_t>(row), step);
    scroll_to_cursor_ = true;
    remark_.clear();
}

void FileBrowser::read_list_keys() {
    const ImGuiIO& io = ImGui::GetIO();
    if (io.KeyAlt) return;
    const auto page = static_cast<std::ptrdiff_t>(std::max<std::size_t>(rows_in_sight_, 2) - 1);
    const auto all = static_cast<std::ptrdiff_t>(shown_.size());
    if (is_key_pressed(GLFW_KEY_UP, KeyRepeat::yes)) move_cursor(-1);
    if (is_key_pressed(GLFW_KEY_DOWN, KeyRepeat::yes)) move_cursor(1);
    if (is_key_pressed(GLFW_KEY_PAGE_UP, KeyRepeat::yes)) move_cursor(-page);
    if (is_key_pressed(GLFW_KEY_PAGE_DOWN, KeyRepeat::yes)) move_cursor(page);
    if (is_key_pressed(GLFW_KEY_HOME)) move_cursor(-all);
    if (is_key_pressed(GLFW_KEY_END)) move_cursor(all);
    if (io.KeyCtrl && is_key_pressed(GLFW_KEY_A)) selection_.select_all();
    if (is_key_pressed(GLFW_KEY_BACKSPACE)) return go_up();
    if (is_enter_pressed()) return activate_cursor();
    if (is_key_pressed(GLFW_KEY_SPACE) && !shown_.empty() && !type_ahead_.is_typing(ImGui::GetTime()))
        return selection_.step(selection_.cursor(), io.KeyCtrl ? SelectionStep::toggle : SelectionStep::only);
    read_type_ahead();
}

void FileBrowser::read_type_ahead() {
    const std::string letters = typed_letters();
    if (letters.empty()) return;
    // These letters begin a path, not a name.
    if (letters == "/" || letters == "~") {
        part_ = Part::field;
        return field_.set(letters);
    }
    const auto row =
        type_ahead_.type(letters, ImGui::GetTime(), listing_.entries, shown_, selection_.cursor());
    if (!row) return;
    selection_.step(*row, SelectionStep::only);
    scroll_to_cursor_ = true;
}

/// Reads the keys of the parts other than the list and the field.
void FileBrowser::read_part_keys() {
    const auto arrows = [](int before, int after, std::size_t& place, std::size_t count) {
        if (is_key_pressed(before, KeyRepeat::yes) && place > 0) --place;
        if (is_key_pressed(after, KeyRepeat::yes) && place + 1 < count) ++place;
        place = std::min(place, count - 1);
    };
    const bool is_pressed = is_enter_pressed() || is_key_pressed(GLFW_KEY_SPACE);
    switch (part_) {
        case Part::type: {
            std::size_t type = type_;
            arrows(GLFW_KEY_UP, GLFW_KEY_DOWN, type, request_.types.size() + 1);
            if (type != type_) set_type(type);
            break;
        }
        case Part::hidden:
            if (is_pressed) toggle_hidden();
            break;
        case Part::new_folder:
            if (is_pressed) ask_for_new_folder();
            break;
        case Part::cancel:
            if (is_pressed) open_ = false;
            break;
        case Part::accept:
            if (is_pressed) accept();
            break;
        case Part::crumbs: {
            const auto folders = folders_on_the_way(folder_);
            arrows(GLFW_KEY_LEFT, GLFW_KEY_RIGHT, crumb_, folders.size());
            if (is_pressed) go_to(folders[crumb_]);
            break;
        }
        case Part::places: {
            const auto places = all_places();
            arrows(GLFW_KEY_UP, GLFW_KEY_DOWN, place_, places.size());
            if (is_pressed) go_to(places[place_].folder);
            break;
        }
        case Part::headings: {
            auto column = static_cast<std::size_t>(column_);
            arrows(GLFW_KEY_LEFT, GLFW_KEY_RIGHT, column, columns_);
            column_ = static_cast<SortColumn>(column);
            if (is_pressed) sort_by(column_);
            break;
        }
        case Part::list:
        case Part::field:
            break;
    }
}

void FileBrowser::toggle_hidden() {
    hidden_ = !hidden_;
    const FolderEntry* const entry = cursor_entry();
    arrange(entry != nullptr ? entry->name : std::filesystem::path());
}

void FileBrowser::set_type(std::size_t type) {
    type_ = type;
    const FolderEntry* const entry = cursor_entry();
    arrange(entry != nullptr ? entry->name : std::filesystem::path());
}

/// Sorts by a column. Sorting by the same column again reverses the order. Sizes and dates begin with the
/// largest and the latest.
void FileBrowser::sort_by(SortColumn column) {
    const bool is_same = order_.column == column;
    order_ = {.column = column, .descending = is_same ? !order_.descending : column != SortColumn::name};
    const FolderEntry* const entry = cursor_entry();
    arrange(entry != nullptr ? entry->name : std::filesystem::path());
}

}  // namespace interleaf
