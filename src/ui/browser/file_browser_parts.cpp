// The appearance of the file browser.
#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/core.h>
#include <imgui.h>

#include "text/shown_text.h"
#include "ui/browser/breadcrumbs.h"
#include "ui/browser/file_browser.h"
#include "ui/browser/file_list.h"
#include "ui/browser/typed_path.h"
#include "ui/widgets/modal.h"
#include "ui/widgets/number_text.h"
#include "ui/widgets/style.h"
#include "ui/widgets/text_field.h"

namespace interleaf {

namespace {

constexpr const char* all_files = "All files";

/// A small button. \p draw(list, middle, size, color) draws its symbol.
template <typename Draw>
bool symbol_button(const char* name, const char* tooltip, Draw draw) {
    const float side = ImGui::GetFrameHeight();
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const bool clicked = ImGui::Button(name, {side, side});
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", tooltip);
    draw(*ImGui::GetWindowDrawList(), glm::vec2(corner.x + side / 2, corner.y + side / 2), side * 0.22F,
         colors::text);
    ImGui::SameLine(0, scaled(4));
    return clicked;
}

void draw_up(ImDrawList& list, glm::vec2 middle, float size, ImU32 color) {
    const float width = scaled(1.5F);
    list.AddLine({middle.x, middle.y + size}, {middle.x, middle.y - size}, color, width);
    list.AddLine({middle.x - size * 0.8F, middle.y - size * 0.2F}, {middle.x, middle.y - size}, color, width);
    list.AddLine({middle.x + size * 0.8F, middle.y - size * 0.2F}, {middle.x, middle.y - size}, color, width);
}

void draw_home(ImDrawList& list, glm::vec2 middle, float size, ImU32 color) {
    list.AddTriangleFilled({middle.x - size * 1.2F, middle.y}, {middle.x, middle.y - size * 1.1F},
                           {middle.x + size * 1.2F, middle.y}, color);
    list.AddRectFilled({middle.x - size * 0.8F, middle.y}, {middle.x + size * 0.8F, middle.y + size}, color);
}

/// \return whether it was clicked
bool place_row(const FilePlace& place, float width, bool is_here, bool is_focused) {
    const float height = std::round(ImGui::GetTextLineHeight() + scaled(8));
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const bool clicked = ImGui::InvisibleButton("place", {width, height});
    const bool is_hovered = ImGui::IsItemHovered();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 end = ImGui::GetItemRectMax();
    if (is_here) {
        list.AddRectFilled(corner, end, ImGui::GetColorU32(ImGuiCol_FrameBg), scaled(4));
    } else if (is_hovered) {
        list.AddRectFilled(corner, end, colors::hover, scaled(4));
    }
    if (is_hovered) ImGui::SetTooltip("%s", shown_name(place.folder.native()).c_str());
    draw_text({corner.x + scaled(8), corner.y + scaled(4)}, width - 2 * scaled(8), colors::text, place.name);
    if (is_focused) draw_focus();
    return clicked;
}

std::string extensions_of(const FileType& type) {
    std::string text;
    for (const std::string& extension : type.extensions) text += (text.empty() ? "" : ", ") + extension;
    return text;
}

}  // namespace

std::optional<FileChoice> FileBrowser::show(const Rect& area) {
    if (!open_) return std::nullopt;
    if (!begin_modal("file browser", area, {scaled(900), scaled(620)})) return std::nullopt;
    if (!std::exchange(is_new_, false) && !dialog_.is_open()) read_keys();

    const float width = ImGui::GetContentRegionAvail().x;
    const float places_width = scaled(160);
    has_places_ = width >= scaled(600);
    is_narrow_ = width < scaled(420);
    if (!is_shown(part_)) part_ = Part::list;
    // A narrow window has no room for the remark beside the buttons; it replaces the title.
    const bool has_remark = is_narrow_ && !remark_.empty();
    draw_text(from_imgui(ImGui::GetCursorScreenPos()), width, has_remark ? colors::notice : colors::text,
              has_remark ? remark_ : request_.title);
    ImGui::Dummy({width, ImGui::GetTextLineHeight() + scaled(2)});
    show_path(width);

    const float below = 2 * (ImGui::GetFrameHeight() + ImGui::GetStyle().ItemSpacing.y) + scaled(4);
    const float height = std::max(ImGui::GetContentRegionAvail().y - below, scaled(60));
    if (has_places_) {
        show_places(places_width, height);
        ImGui::SameLine();
    }
    show_list(ImGui::GetContentRegionAvail().x, height);
    ImGui::Dummy({0, 0});
    show_field(width);
    show_buttons(width);
    if (const auto answer = dialog_.show(area)) take_answer(*answer);
    end_modal(!open_);
    return std::exchange(choice_, std::nullopt);
}

void FileBrowser::show_path(float width) {
    const float left = ImGui::GetCursorPosX();
    if (symbol_button("##up", "Folder above (Backspace)", draw_up)) go_up();
    if (symbol_button("##home", "Home (Alt+Home)", draw_home)) go_to(home_folder());
    const auto folders = folders_on_the_way(folder_);
    const auto focused = part_ == Part::crumbs ? std::optional(crumb_) : std::nullopt;
    if (const auto clicked = breadcrumbs(folders, left + width - ImGui::GetCursorPosX(), focused))
        go_to(folders[*clicked]);
}

void FileBrowser::show_places(float width, float height) {
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0, scaled(1)});
    ImGui::BeginChild("places", {width, height}, false, ImGuiWindowFlags_NoNav);
    const auto places = all_places();
    const std::size_t first_recent = places.size() - request_.recent_folders.size();
    const float room = ImGui::GetContentRegionAvail().x;
    for (std::size_t i = 0; i < places.size(); ++i) {
        if (i == 0 || i == first_recent) {
            ImGui::Dummy({0, i == 0 ? scaled(4) : scaled(10)});
            ImGui::SetCursorPosX(ImGui::GetCursorPosX() + scaled(8));
            heading(i == 0 ? "Places" : "Recent");
            ImGui::Dummy({0, scaled(2)});
        }
        ImGui::PushID(static_cast<int>(i));
        const bool is_focused = part_ == Part::places && place_ == i;
        if (place_row(places[i], room, places[i].folder == folder_, is_focused)) {
            place_ = i;
            part_ = Part::list;
            go_to(places[i].folder);
        }
        if (is_focused) ImGui::SetScrollHereY();
        ImGui::PopID();
    }
    ImGui::EndChild();
    ImGui::PopStyleVar();
}

void FileBrowser::show_list(float width, float height) {
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const auto column = part_ == Part::headings ? std::optional(column_) : std::nullopt;
    const FileListResult result =
        file_list({width, height}, {.entries = listing_.entries,
                                    .shown = shown_,
                                    .selection = selection_,
                                    .order = order_,
                                    .is_focused = part_ == Part::list && !dialog_.is_open(),
                                    .focused_column = column,
                                    .scroll_to_cursor = std::exchange(scroll_to_cursor_, false)});
    rows_in_sight_ = result.rows_in_sight;
    columns_ = columns_in(width).size();
    if (shown_.empty() || !listing_.error.empty()) show_nothing(corner.x, corner.y, width, height);
    if (result.sort_by) sort_by(*result.sort_by);
    if (!result.clicked) return;
    part_ = Part::list;
    remark_.clear();
    selection_.step(*result.clicked, result.step);
    const FolderEntry& entry = listing_.entries[shown_[*result.clicked]];
    // The field cannot hold every name. The user chooses other names by a double click or Enter.
    const bool is_target = entry.is_folder() == wants_folder();
    if (is_saving() && is_target && is_editable(entry.name.native())) field_.set(entry.name.native());
    if (result.is_double_click) activate_cursor();
}

/// Explains why the list is empty or incomplete, and offers a remedy.
void FileBrowser::show_nothing(float left, float top, float width, float height) {
    const auto has_hidden = [this] {
        return !hidden_ && std::ranges::any_of(listing_.entries, &FolderEntry::is_hidden);
    };
    const auto has_others = [this] {
        return std::ranges::any_of(listing_.entries,
                                   [this](const FolderEntry& e) { return hidden_ || !e.is_hidden(); });
    };
    std::string text = "This folder is empty.";
    const char* button = nullptr;
    if (!listing_.error.empty()) {
        text = fmt::format("This folder cannot be read: {}", listing_.error);
    } else if (has_others() && wants_folder()) {
        text = "This folder contains no folders.";
    } else if (has_others()) {
        text = fmt::format("No files of the type {} ({}).", type().name, extensions_of(type()));
        button = "Show all files";
    } else if (has_hidden()) {
        text = "This folder contains only hidden files.";
        button = "Show hidden files";
    }
    // An incomplete listing keeps its rows, with the reason below them.
    const bool has_rows = !shown_.empty();
    const float line = ImGui::GetTextLineHeight();
    const float text_width = std::min(text_size(text).x, width - 2 * scaled(12));
    const float text_top = has_rows ? top + height - line - scaled(6) : top + height * 0.42F;
    const ImVec2 after = ImGui::GetCursorPos();
    // A child window of its own is drawn over the list.
    ImGui::SetCursorScreenPos({left + scaled(8), text_top});
    ImGui::BeginChild("nothing", {width - 2 * scaled(8), line + ImGui::GetFrameHeight() + scaled(16)}, false,
                      ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoScrollbar);
    draw_text({left + (width - text_width) / 2, text_top}, text_width + 1,
              listing_.error.empty() ? colors::dim_text : colors::notice, text);
    if (button != nullptr) {
        const float button_width = modal_button_width(button);
        ImGui::SetCursorScreenPos({left + (width - button_width) / 2, text_top + line + scaled(10)});
        if (modal_button({.label = button, .width = button_width})) {
            if (has_others())
                set_type(request_.types.size());
            else
                toggle_hidden();
        }
    }
    ImGui::EndChild();
    ImGui::SetCursorPos(after);
}

void FileBrowser::show_field(float width) {
    const float left = ImGui::GetCursorPosX();
    const char* const label = is_saving() ? "Name" : "Path";
    ImGui::AlignTextToFramePadding();
    ImGui::PushStyleColor(ImGuiCol_Text, colors::dim_text);
    ImGui::TextUnformatted(label);
    ImGui::PopStyleColor();
    ImGui::SameLine();
    const bool has_types = is_shown(Part::type);
    const float types_width = has_types ? std::min(scaled(200), width * 0.35F) : 0;
    const float end = left + width - types_width - (has_types ? ImGui::GetStyle().ItemSpacing.x : 0);
    const bool is_focused = part_ == Part::field && !dialog_.is_open() && open_;
    std::size_t names = 0;
    const auto complete = [&](const std::string& text) {
        PathCompletion completion = completed_path(text, folder_, home_folder());
        names = completion.names;
        return completion.text;
    };
    const TextFieldResult result = field_.show("##path", is_saving() ? "" : "Type or paste a path (Ctrl+L)",
                                               end - ImGui::GetCursorPosX(), is_focused, complete);
    if (result.clicked) part_ = Part::field;
    if (result.tabbed) leave_field(names);
    if (result.entered && !ImGui::GetIO().KeyCtrl) {
        field_.refocus();
        if (is_saving() || field_.text().find_first_not_of(' ') != std::string::npos) accept_text();
    }
    if (has_types) {
        ImGui::SameLine();
        show_types(types_width);
    }
}

/// Reacts to a Tab that has completed nothing. If several \p names match, only a second Tab leaves the field.
void FileBrowser::leave_field(std::size_t names) {
    const std::string text = field_.text();
    if (names <= 1 || text.empty() || std::exchange(ambiguous_, text) == text) return move_part(1);
    remark_ = fmt::format("{} names begin with this text.", grouped(names));
}

void FileBrowser::show_types(float width) {
    const auto name = [this](std::size_t i) {
        return i < request_.types.size() ? request_.types[i].name.c_str() : all_files;
    };
    ImGui::SetNextItemWidth(width);
    types_unfolded_ = ImGui::BeginCombo("##type", name(type_));
    if (types_unfolded_) {
        for (std::size_t i = 0; i <= request_.types.size(); ++i)
            if (ImGui::Selectable(name(i), i == type_)) set_type(i);
        ImGui::EndCombo();
    } else {
        if (ImGui::IsItemHovered() && type_ < request_.types.size())
            ImGui::SetTooltip("%s", extensions_of(type()).c_str());
        if (part_ == Part::type) draw_focus();
    }
}

void FileBrowser::show_buttons(float width) {
    const float left = ImGui::GetCursorPosX();
    const float spacing = ImGui::GetStyle().ItemSpacing.x;
    const float accept_width = modal_button_width(request_.action);
    const float cancel_width = modal_button_width("Cancel");
    const float buttons_left = left + width - accept_width - spacing - cancel_width;

    const float small = scaled(14);
    const float hidden_width = small + scaled(6) + text_size("Hidden").x;
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const float frame = ImGui::GetFrameHeight();
    if (ImGui::InvisibleButton("##hidden", {hidden_width + scaled(8), frame})) toggle_hidden();
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("Show hidden files (Ctrl+H)");
    if (part_ == Part::hidden) draw_focus();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 box{corner.x + scaled(4), std::round(corner.y + (frame - small) / 2)};
    list.AddRectFilled(box, {box.x + small, box.y + small}, ImGui::GetColorU32(ImGuiCol_FrameBg), scaled(3));
    if (hidden_)
        list.AddRectFilled({box.x + scaled(3), box.y + scaled(3)},
                           {box.x + small - scaled(3), box.y + small - scaled(3)}, colors::accent, scaled(2));
    draw_text({box.x + small + scaled(6), corner.y + ImGui::GetStyle().FramePadding.y}, hidden_width,
              colors::dim_text, "Hidden");
    ImGui::SameLine();
    if (is_shown(Part::new_folder)) {
        if (modal_button({.label = "New folder…",
                          .width = modal_button_width("New folder…"),
                          .is_focused = part_ == Part::new_folder}))
            ask_for_new_folder();
        ImGui::SameLine();
    }
    show_remark(ImGui::GetCursorPosX() + scaled(4), buttons_left - ImGui::GetCursorPosX() - scaled(12));

    ImGui::SetCursorPosX(buttons_left);
    if (modal_button({.label = "Cancel", .width = cancel_width, .is_focused = part_ == Part::cancel}))
        open_ = false;
    ImGui::SameLine();
    if (modal_button({.label = request_.action.c_str(),
                      .width = accept_width,
                      .is_main = true,
                      .is_focused = part_ == Part::accept}))
        accept();
}

std::string FileBrowser::summary() const {
    if (selection_.count() > 1) {
        std::uint64_t bytes = 0;
        for (const std::size_t row : selection_.rows()) bytes += listing_.entries[shown_[row]].size;
        return fmt::format("{} selected, {}", grouped(selection_.count()), size_text(bytes));
    }
    if (shown_.empty()) return "";
    return fmt::format("{} {}", grouped(shown_.size()), shown_.size() == 1 ? "entry" : "entries");
}

void FileBrowser::show_remark(float left, float width) {
    ImGui::SetCursorPosX(left);
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    if (width > scaled(24)) {
        const std::string text = remark_.empty() ? summary() : remark_;
        draw_text({corner.x, corner.y + ImGui::GetStyle().FramePadding.y}, width,
                  remark_.empty() ? colors::dim_text : colors::notice, text);
        ImGui::Dummy({width, ImGui::GetFrameHeight()});
        if (ImGui::IsItemHovered() && text_size(text).x > width) ImGui::SetTooltip("%s", text.c_str());
        ImGui::SameLine();
    }
}

}  // namespace interleaf
