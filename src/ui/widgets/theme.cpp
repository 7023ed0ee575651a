#include "ui/widgets/theme.h"

#include "ui/widgets/gui_state.h"

namespace interleaf {

namespace {

constexpr Palette dark_palette{
    .text = IM_COL32(222, 226, 232, 255),
    .dim_text = IM_COL32(152, 160, 174, 255),
    .accent = IM_COL32(92, 164, 255, 255),
    .notice = IM_COL32(240, 190, 90, 255),
    .ink = IM_COL32(255, 255, 255, 255),
    .rim = IM_COL32(12, 13, 16, 255),
    .label = IM_COL32(16, 18, 22, 200),
    .well = IM_COL32(20, 22, 27, 255),
    .faint_line = IM_COL32(62, 68, 80, 255),
    .hover = IM_COL32(255, 255, 255, 14),
    .window = IM_COL32(30, 33, 40, 255),
    .popup = IM_COL32(36, 40, 48, 255),
    .menu_bar = IM_COL32(24, 26, 32, 255),
    .border = IM_COL32(14, 15, 19, 255),
    .separator = IM_COL32(48, 53, 63, 255),
    .frame = IM_COL32(46, 51, 61, 255),
    .frame_hovered = IM_COL32(60, 67, 80, 255),
    .chosen = IM_COL32(44, 90, 148, 255),
    .chosen_hovered = IM_COL32(52, 99, 160, 255),
    .selected = IM_COL32(48, 76, 112, 255),
    .selected_hovered = IM_COL32(52, 88, 134, 255),
    .scrollbar = IM_COL32(62, 68, 80, 255),
    .scrollbar_hovered = IM_COL32(78, 86, 101, 255),
    .selected_text = IM_COL32(54, 102, 163, 160),
};

constexpr Palette light_palette{
    .text = IM_COL32(28, 32, 40, 255),
    .dim_text = IM_COL32(82, 90, 103, 255),
    .accent = IM_COL32(20, 95, 190, 255),
    .notice = IM_COL32(140, 80, 0, 255),
    .ink = IM_COL32(28, 32, 40, 255),
    .rim = IM_COL32(255, 255, 255, 255),
    .label = IM_COL32(255, 255, 255, 215),
    .well = IM_COL32(226, 229, 234, 255),
    .faint_line = IM_COL32(190, 196, 206, 255),
    .hover = IM_COL32(0, 0, 0, 12),
    .window = IM_COL32(244, 245, 247, 255),
    .popup = IM_COL32(252, 252, 253, 255),
    .menu_bar = IM_COL32(232, 234, 238, 255),
    .border = IM_COL32(203, 208, 216, 255),
    .separator = IM_COL32(214, 218, 225, 255),
    .frame = IM_COL32(224, 228, 234, 255),
    .frame_hovered = IM_COL32(210, 216, 225, 255),
    .chosen = IM_COL32(160, 199, 246, 255),
    .chosen_hovered = IM_COL32(146, 190, 243, 255),
    .selected = IM_COL32(202, 222, 247, 255),
    .selected_hovered = IM_COL32(188, 213, 245, 255),
    .scrollbar = IM_COL32(196, 202, 211, 255),
    .scrollbar_hovered = IM_COL32(172, 180, 192, 255),
    .selected_text = IM_COL32(120, 178, 246, 160),
};

}  // namespace

const Palette& palette_of(Theme theme) {
    return theme == Theme::dark ? dark_palette : light_palette;
}

ThemeColor::operator ImU32() const {
    const GuiState* const state = gui_state();
    return palette_of(state != nullptr ? state->theme : Theme::dark).*color_;
}

void set_colors(ImGuiStyle& style) {
    const GuiState* const state = gui_state();
    const Palette& palette = palette_of(state != nullptr ? state->theme : Theme::dark);
    const auto set = [&](ImGuiCol place, ImU32 color) {
        style.Colors[place] = ImGui::ColorConvertU32ToFloat4(color);
    };
    set(ImGuiCol_Text, palette.text);
    set(ImGuiCol_TextDisabled, palette.dim_text);
    set(ImGuiCol_WindowBg, palette.window);
    set(ImGuiCol_PopupBg, palette.popup);
    set(ImGuiCol_MenuBarBg, palette.menu_bar);
    set(ImGuiCol_Border, palette.border);
    set(ImGuiCol_FrameBg, palette.frame);
    set(ImGuiCol_FrameBgHovered, palette.frame_hovered);
    set(ImGuiCol_FrameBgActive, palette.chosen_hovered);
    set(ImGuiCol_Button, palette.frame);
    set(ImGuiCol_ButtonHovered, palette.frame_hovered);
    set(ImGuiCol_ButtonActive, palette.chosen);
    set(ImGuiCol_Header, palette.selected);
    set(ImGuiCol_HeaderHovered, palette.selected_hovered);
    set(ImGuiCol_HeaderActive, palette.chosen);
    set(ImGuiCol_CheckMark, palette.accent);
    set(ImGuiCol_SliderGrab, palette.accent);
    set(ImGuiCol_SliderGrabActive, palette.accent);
    set(ImGuiCol_ModalWindowDimBg, 0);  // begin_modal() dims the background itself
    set(ImGuiCol_Separator, palette.separator);
    set(ImGuiCol_ScrollbarBg, 0);
    set(ImGuiCol_ScrollbarGrab, palette.scrollbar);
    set(ImGuiCol_ScrollbarGrabHovered, palette.scrollbar_hovered);
    set(ImGuiCol_ScrollbarGrabActive, palette.accent);
    set(ImGuiCol_NavHighlight, palette.accent);
    set(ImGuiCol_TextSelectedBg, palette.selected_text);
}

}  // namespace interleaf
