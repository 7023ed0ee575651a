#include "ui/widgets/modal.h"

#include <cmath>

#define GLFW_INCLUDE_NONE

#include <algorithm>

#include <GLFW/glfw3.h>
#include <imgui.h>
#include <imgui_internal.h>

#include "ui/widgets/style.h"

namespace interleaf {

namespace {

/// Dims everything behind the window. Dear ImGui would dim it gradually, over frames that are not drawn while
/// nothing happens.
void dim_behind() {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 corner = ImGui::GetWindowPos();
    const ImVec2 size = ImGui::GetWindowSize();
    const ImVec2 end{corner.x + size.x, corner.y + size.y};
    const float rounding = ImGui::GetStyle().PopupRounding;
    list.PushClipRectFullScreen();
    list.AddRectFilled({0, 0}, ImGui::GetIO().DisplaySize, IM_COL32(0, 0, 0, 130));
    list.AddRectFilled(corner, end, ImGui::GetColorU32(ImGuiCol_PopupBg), rounding);
    list.AddRect(corner, end, colors::faint_line, rounding);
    list.PopClipRect();
}

}  // namespace

bool begin_modal(const char* name, const Rect& area, glm::vec2 size) {
    if (!ImGui::IsPopupOpen(name)) ImGui::OpenPopup(name);
    const float margin = scaled(12);
    const float width = std::clamp(area.width - 2 * margin, 1.0F, size.x);
    const float height = std::clamp(area.height - 2 * margin, 1.0F, size.y);
    ImGui::SetNextWindowPos(
        {std::round(area.x + (area.width - width) / 2), std::round(area.y + (area.height - height) / 2)});
    ImGui::SetNextWindowSize({std::round(width), std::round(height)});
    ImGui::PushStyleVar(ImGuiStyleVar_PopupRounding, scaled(6));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, scaled(6));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {scaled(16), scaled(14)});
    const bool shown = ImGui::BeginPopupModal(name, nullptr,
                                              ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize |
                                                  ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                                                  ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoScrollbar);
    if (shown) dim_behind();
    ImGui::PopStyleVar(3);
    return shown;
}

void end_modal(bool closing) {
    if (closing) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
}

bool modal_button(const ModalButton& button) {
    if (button.is_main) {
        ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetStyleColorVec4(ImGuiCol_Header));
        ImGui::PushStyleColor(ImGuiCol_ButtonHovered, ImGui::GetStyleColorVec4(ImGuiCol_HeaderHovered));
    }
    const bool clicked = ImGui::Button(button.label, {button.width, 0});
    if (button.is_main) ImGui::PopStyleColor(2);
    if (button.has_accelerator) {
        const ImVec2 corner = ImGui::GetItemRectMin();
        const ImVec2 end = ImGui::GetItemRectMax();
        const float left = corner.x + (end.x - corner.x - text_size(button.label).x) / 2;
        const float bottom = end.y - ImGui::GetStyle().FramePadding.y;
        const float letter = text_size({button.label, 1}).x;
        ImGui::GetWindowDrawList()->AddLine({left, bottom}, {left + letter, bottom}, colors::dim_text);
    }
    if (button.is_focused) draw_focus();
    return clicked;
}

std::optional<bool> main_and_cancel(const char* label, bool is_main_focused, bool is_cancel_focused) {
    std::optional<bool> pressed;
    const float main_width = modal_button_width(label);
    const float cancel_width = modal_button_width("Cancel");
    const float free_width =
        ImGui::GetContentRegionAvail().x - main_width - cancel_width - ImGui::GetStyle().ItemSpacing.x;
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + free_width);
    if (modal_button({.label = label, .width = main_width, .is_main = true, .is_focused = is_main_focused}))
        pressed = true;
    ImGui::SameLine();
    if (modal_button({.label = "Cancel", .width = cancel_width, .is_focused = is_cancel_focused}))
        pressed = false;
    return pressed;
}

float modal_button_width(const std::string& label) {
    return std::max(text_size(label).x + 2 * scaled(16), scaled(84));
}

void draw_focus() {
    const ImVec2 corner = ImGui::GetItemRectMin();
    const ImVec2 end = ImGui::GetItemRectMax();
    ImGui::GetWindowDrawList()->AddRect(corner, end, colors::accent, ImGui::GetStyle().FrameRounding,
                                        ImDrawFlags_None, scaled(1.5F));
}

bool is_key_pressed(int key, KeyRepeat repeat) {
    return ImGui::IsKeyPressed(key, repeat == KeyRepeat::yes);
}

bool is_enter_pressed() {
    return is_key_pressed(GLFW_KEY_ENTER) || is_key_pressed(GLFW_KEY_KP_ENTER);
}

std::string typed_letters() {
    const ImGuiIO& io = ImGui::GetIO();
    std::string letters;
    if (io.KeyCtrl || io.KeyAlt) return letters;
    for (const ImWchar letter : io.InputQueueCharacters) {
        char bytes[5];
        letters += ImTextCharToUtf8(bytes, letter);
    }
    return letters;
}

}  // namespace interleaf
