#include "ui/widgets/section.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <imgui.h>

#include "ui/widgets/gui_state.h"
#include "ui/widgets/modal.h"
#include "ui/widgets/style.h"

namespace interleaf {

namespace {

/// A triangle that points down at an open section, and to the right at a closed one.
void draw_mark(glm::vec2 middle, bool is_open, ImU32 color) {
    const float half = scaled(3.5F);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    if (is_open)
        list.AddTriangleFilled({middle.x - half, middle.y - half / 2}, {middle.x + half, middle.y - half / 2},
                               {middle.x, middle.y + half / 2 + 1}, color);
    else
        list.AddTriangleFilled({middle.x - half / 2, middle.y - half}, {middle.x + half / 2 + 1, middle.y},
                               {middle.x - half / 2, middle.y + half}, color);
}

}  // namespace

bool section(std::string_view title, std::string_view remark, const char* meaning) {
    GuiState* const state = gui_state();
    bool is_open = state == nullptr || !state->closed_sections.contains(title);
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const float room = ImGui::GetContentRegionAvail().x;
    ImGui::PushFont(small_font());
    const float line = ImGui::GetTextLineHeight();
    const float width = text_size(title).x;
    // The remark may be a button of its own.
    const float button = std::max(std::min(width + scaled(22), room - text_size(remark).x), 1.0F);
    ImGui::PopFont();
    if (state != nullptr) {
        ImGui::PushID("section");
        const std::string id(title);
        const bool is_clicked = ImGui::InvisibleButton(id.c_str(), {button, line});
        if (shows_focus() && ImGui::IsItemFocused()) draw_focus();
        const bool is_hovered = ImGui::IsItemHovered();
        if (is_clicked && is_open) state->closed_sections.emplace(title);
        if (is_clicked && !is_open) state->closed_sections.erase(id);
        if (is_clicked) is_open = !is_open;
        if (is_hovered)
            ImGui::SetTooltip("%s%sClick to %s this part.", meaning != nullptr ? meaning : "",
                              meaning != nullptr ? "\n" : "", is_open ? "close" : "open");
        ImGui::PopID();
        draw_mark({corner.x + width + scaled(11), corner.y + std::round(line / 2)}, is_open,
                  is_hovered ? colors::text : colors::dim_text);
        ImGui::SetCursorScreenPos(corner);
    }
    heading(title, remark);
    return is_open;
}

void open_section(std::string_view title) {
    if (GuiState* const state = gui_state()) state->closed_sections.erase(std::string(title));
}

}  // namespace interleaf
