#include "ui/browser/file_list.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <string_view>

#include <imgui.h>

#include "ui/widgets/row_clipper.h"
#include "ui/widgets/style.h"

namespace interleaf {

namespace {

constexpr std::array columns{SortColumn::name, SortColumn::size, SortColumn::modified};
constexpr std::array<const char*, 3> headings{"Name", "Size", "Modified"};

float width_of(SortColumn column) {
    return column == SortColumn::size ? scaled(76) : scaled(138);
}

float side_margin() {
    return scaled(10);
}

/// The left and right edge of a column.
struct Span {
    float left;
    float right;
};

/// The edges of \p column in a list from \p left to \p right. The name gets the width that the others leave.
Span span_of(SortColumn column, float left, float right) {
    const auto present = columns_in(right - left);
    float end = right;
    for (std::size_t i = present.size(); i-- > 1;) {
        const float begin = end - width_of(present[i]);
        if (present[i] == column) return {begin, end};
        end = begin;
    }
    return {left, end};
}

void draw_folder(ImDrawList& list, glm::vec2 corner, float side, ImU32 color) {
    const float top = corner.y + side * 0.14F;
    list.AddRectFilled({corner.x, top}, {corner.x + side * 0.5F, top + side * 0.3F}, color, side * 0.1F);
    list.AddRectFilled({corner.x, top + side * 0.14F}, {corner.x + side, corner.y + side * 0.9F}, color,
                       side * 0.1F);
}

void draw_page(ImDrawList& list, glm::vec2 corner, float side, ImU32 color) {
    const float left = std::round(corner.x + side * 0.16F) + 0.5F;
    const float right = std::round(corner.x + side * 0.84F) + 0.5F;
    const float top = std::round(corner.y + side * 0.04F) + 0.5F;
    const float bottom = std::round(corner.y + side * 0.96F) + 0.5F;
    const float ear = side * 0.26F;
    list.PathLineTo({left, top});
    list.PathLineTo({right - ear, top});
    list.PathLineTo({right, top + ear});
    list.PathLineTo({right, bottom});
    list.PathLineTo({left, bottom});
    list.PathStroke(color, ImDrawFlags_Closed, scaled(1));
}

/// \param marks_order  1 marks the ascending order, -1 the descending order, 0 none
void draw_heading(const Span& span, float top, float height, const char* text, bool at_right,
                  int marks_order) {
    const float arrow = scaled(4);
    const float width = text_size(text).x;
    const float left = at_right ? span.right - side_margin() - width : span.left + side_margin();
    const ImU32 color = marks_order != 0 ? colors::text : colors::dim_text;
    draw_text({left, top + (height - ImGui::GetTextLineHeight()) / 2}, span.right - left, color, text);
    if (marks_order == 0) return;
    const glm::vec2 middle{at_right ? left - 2 * arrow : left + width + 2 * arrow, top + height / 2};
    const auto up = static_cast<float>(marks_order);
    ImGui::GetWindowDrawList()->AddTriangleFilled({middle.x - arrow, middle.y + up * arrow / 2},
                                                  {middle.x + arrow, middle.y + up * arrow / 2},
                                                  {middle.x, middle.y - up * arrow / 2}, colors::accent);
}

std::optional<SortColumn> show_headings(float width, const FileListState& state) {
    std::optional<SortColumn> clicked;
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const float height = scaled(24);
    ImGui::PushFont(small_font());
    for (const SortColumn column : columns_in(width)) {
        const auto index = static_cast<std::size_t>(column);
        const Span span = span_of(column, corner.x, corner.x + width);
        ImGui::SetCursorScreenPos({span.left, corner.y});
        if (ImGui::InvisibleButton(headings.at(index), {span.right - span.left, height})) clicked = column;
        if (ImGui::IsItemHovered())
            ImGui::GetWindowDrawList()->AddRectFilled(ImGui::GetItemRectMin(), ImGui::GetItemRectMax(),
                                                      ImGui::GetColorU32(ImGuiCol_FrameBg), scaled(4));
        const int order = state.order.column != column ? 0 : state.order.descending ? -1 : 1;
        draw_heading(span, corner.y, height, headings.at(index), column == SortColumn::size, order);
        if (state.focused_column == column)
            ImGui::GetWindowDrawList()->AddRect({span.left + 1, corner.y + 1},
                                                {span.right - 1, corner.y + height}, colors::accent,
                                                scaled(4), ImDrawFlags_None, scaled(1.5F));
    }
    ImGui::PopFont();
    ImGui::SetCursorScreenPos({corner.x, corner.y + height});
    return clicked;
}

float row_height() {
    return std::round(ImGui::GetTextLineHeight() + scaled(7));
}

struct RowLook {
    bool is_selected;
    bool is_hovered;
    bool has_cursor;  ///< the cursor is on the row, and the list has the keyboard
    bool is_focused;  ///< the list has the keyboard
};

void draw_row_background(ImVec2 corner, ImVec2 end, const RowLook& look) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float rounding = scaled(4);
    if (look.is_selected) {
        list.AddRectFilled(
            corner, end, ImGui::GetColorU32(look.is_focused ? ImGuiCol_Header : ImGuiCol_FrameBg), rounding);
    } else if (look.is_hovered) {
        list.AddRectFilled(corner, end, colors::hover, rounding);
    }
    if (look.has_cursor)
        list.AddRect({corner.x + 0.5F, corner.y + 0.5F}, {end.x - 0.5F, end.y - 0.5F}, colors::accent,
                     rounding, ImDrawFlags_None, scaled(1));
}

std::string_view remark_on(const FolderEntry& entry) {
    if (entry.kind == EntryKind::broken_link) return "broken link";
    return entry.kind == EntryKind::other ? "not a file" : "";
}

void draw_row(const FolderEntry& entry, ImVec2 corner, float width, const RowLook& look) {
    const float height = row_height();
    const float right = corner.x + width;
    draw_row_background(corner, {right, corner.y + height}, look);

    const float text_top = std::round(corner.y + (height - ImGui::GetTextLineHeight()) / 2);
    const float side = scaled(14);
    const glm::vec2 icon{corner.x + side_margin(), std::round(corner.y + (height - side) / 2)};
    ImDrawList& list = *ImGui::GetWindowDrawList();
    if (entry.is_folder()) {
        draw_folder(list, icon, side, IM_COL32(112, 150, 196, 255));
    } else {
        draw_page(list, icon, side, colors::dim_text);
    }
    const bool is_usable = entry.kind == EntryKind::folder || entry.kind == EntryKind::file;
    const Span name = span_of(SortColumn::name, corner.x, right);
    const float name_left = icon.x + side + scaled(8);
    draw_text({name_left, text_top}, name.right - scaled(8) - name_left,
              is_usable ? colors::text : colors::dim_text, entry.label);

    for (const SortColumn column : columns_in(width)) {
        const Span span = span_of(column, corner.x, right);
        if (column == SortColumn::size) {
            const std::string text =
                entry.kind == EntryKind::file ? size_text(entry.size) : std::string(remark_on(entry));
            const float text_left = std::max(span.right - side_margin() - text_size(text).x, span.left);
            draw_text({text_left, text_top}, span.right - text_left, colors::dim_text, text);
        } else if (column == SortColumn::modified) {
            draw_text({span.left + side_margin(), text_top}, span.right - span.left - side_margin(),
                      colors::dim_text, date_text(entry.modified));
        }
    }
}

SelectionStep step_of_click() {
    const ImGuiIO& io = ImGui::GetIO();
    if (io.KeyShift) return SelectionStep::extend;
    return io.KeyCtrl ? SelectionStep::toggle : SelectionStep::only;
}

void scroll_to(std::size_t row, float sight) {
    const float top = static_cast<float>(row) * row_height();
    if (top < ImGui::GetScrollY()) ImGui::SetScrollY(top);
    if (top + row_height() > ImGui::GetScrollY() + sight) ImGui::SetScrollY(top + row_height() - sight);
}

void show_rows(float width, const FileListState& state, FileListResult& result) {
    RowClipper clipper(state.shown.size(), row_height());
    while (clipper.Step()) {
        for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
            const auto row = static_cast<std::size_t>(i);
            const FolderEntry& entry = state.entries[state.shown[row]];
            const ImVec2 corner = ImGui::GetCursorScreenPos();
            ImGui::Dummy({width, row_height()});
            const bool is_hovered = ImGui::IsItemHovered();
            draw_row(entry, corner, width,
                     {.is_selected = state.selection.is_selected(row),
                      .is_hovered = is_hovered,
                      .has_cursor = state.is_focused && row == state.selection.cursor(),
                      .is_focused = state.is_focused});
            if (!is_hovered || !ImGui::IsMouseClicked(ImGuiMouseButton_Left)) continue;
            result.clicked = row;
            result.step = step_of_click();
            result.is_double_click = ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left);
        }
    }
}

}  // namespace

std::span<const SortColumn> columns_in(float width) {
    const bool has_size = width >= scaled(260);
    const bool has_date = width >= scaled(400);
    return std::span(columns).first(has_date ? 3 : has_size ? 2 : 1);
}

FileListResult file_list(glm::vec2 size, const FileListState& state) {
    FileListResult result;
    ImGui::PushStyleColor(ImGuiCol_ChildBg, colors::well);
    ImGui::PushStyleVar(ImGuiStyleVar_ChildRounding, scaled(4));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0, 0});
    ImGui::BeginChild(
        "list", to_imgui(size), false,
        ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
    // Reserve room for the scroll bar even if there is none, so that the columns stay aligned.
    const float inner = size.x - ImGui::GetStyle().ScrollbarSize;
    result.sort_by = show_headings(inner, state);
    const float sight = ImGui::GetContentRegionAvail().y;
    ImGui::BeginChild("rows", {size.x, sight}, false, ImGuiWindowFlags_NoNav);
    if (!state.shown.empty() && state.scroll_to_cursor) scroll_to(state.selection.cursor(), sight);
    ImGui::PushClipRect(ImGui::GetWindowPos(),
                        {ImGui::GetWindowPos().x + size.x, ImGui::GetWindowPos().y + sight}, true);
    show_rows(inner, state, result);
    ImGui::PopClipRect();
    result.rows_in_sight = static_cast<std::size_t>(std::max(sight / row_height(), 1.0F));
    ImGui::EndChild();
    ImGui::EndChild();
    ImGui::PopStyleVar(3);
    ImGui::PopStyleColor();
    return result;
}

}  // namespace interleaf
