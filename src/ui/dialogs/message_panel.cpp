#include "ui/dialogs/message_panel.h"

#include <algorithm>

#include <glm/common.hpp>
#include <imgui.h>

#include "ui/widgets/style.h"

namespace interleaf {

namespace {

constexpr std::size_t max_pictures = 2;

/// Shows two pictures and their captions in a panel of this width, at most \p height high. Shows nothing if
/// that is too little.
void show_pictures(std::span<const MessagePicture> pictures, float width, float height) {
    const float gap = ImGui::GetStyle().ItemSpacing.x;
    const float caption = ImGui::GetTextLineHeightWithSpacing();
    glm::vec2 size = message_picture_size();
    size *= std::min({1.0F, (width - gap) / (max_pictures * size.x), (height - caption) / size.y});
    size = glm::floor(size);
    if (size.y < scaled(60)) return;
    const glm::vec2 corner = from_imgui(ImGui::GetCursorScreenPos());
    ImDrawList& list = *ImGui::GetWindowDrawList();
    glm::vec2 left = corner;
    for (const MessagePicture& picture : pictures) {
        list.AddImageRounded(texture_id(picture.texture), to_imgui(left), to_imgui(left + size), {0, 0},
                             {1, 1}, colors::white, scaled(4));
        draw_text({left.x, left.y + size.y + ImGui::GetStyle().ItemSpacing.y / 2}, size.x, colors::dim_text,
                  picture.caption);
        left.x += size.x + gap;
    }
    ImGui::Dummy({width, size.y + caption});
}

}  // namespace

glm::vec2 message_picture_size() {
    return {scaled(304), scaled(228)};
}

bool message_panel(const std::string& message, std::span<const MessagePicture> pictures, const Rect& area) {
    if (message.empty()) return false;
    const float margin = scaled(12);
    const float width = std::min(scaled(640), area.width - 2 * margin);
    ImGui::SetNextWindowPos({area.x + area.width / 2, area.y + margin}, ImGuiCond_Always, {0.5F, 0});
    ImGui::SetNextWindowSizeConstraints({width, 0}, {width, area.height - 2 * margin});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, scaled(6));
    ImGui::PushStyleColor(ImGuiCol_Border, colors::notice);
    ImGui::Begin("message", nullptr,
                 ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize |
                     ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoCollapse |
                     ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoNav);
    wrapped_text(message, colors::text);
    ImGui::Spacing();
    if (!pictures.empty()) {
        const float used =
            ImGui::GetCursorPosY() + ImGui::GetFrameHeightWithSpacing() + ImGui::GetStyle().WindowPadding.y;
        show_pictures(pictures.first(std::min(pictures.size(), max_pictures)),
                      ImGui::GetContentRegionAvail().x, area.height - 2 * margin - used);
        ImGui::Spacing();
    }
    if (ImGui::Button("Copy")) ImGui::SetClipboardText(message.c_str());
    ImGui::SameLine();
    const bool dismissed = ImGui::Button("Dismiss");
    ImGui::End();
    ImGui::PopStyleColor();
    ImGui::PopStyleVar();
    return dismissed;
}

NoticeResult notice_panel(const std::string& text, const char* button, const Rect& area) {
    if (text.empty()) return {};
    const float margin = scaled(12);
    const float widest = std::min(scaled(360), area.width - 2 * margin);
    ImGui::PushFont(small_font());
    const ImVec2 padding = ImGui::GetStyle().WindowPadding;
    const float width = std::min(text_size(text).x + 2 * padding.x + 1, widest);
    ImGui::SetNextWindowPos({area.x + margin, area.bottom() - margin}, ImGuiCond_Always, {0, 1});
    ImGui::SetNextWindowSizeConstraints({width, 0}, {width, area.height - 2 * margin});
    ImGui::SetNextWindowBgAlpha(0.9F);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, scaled(6));
    ImGui::PushStyleColor(ImGuiCol_Border, ImGui::GetStyleColorVec4(ImGuiCol_Separator));
    ImGui::Begin("notice", nullptr,
                 ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize |
                     ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoCollapse |
                     ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoNav |
                     ImGuiWindowFlags_NoFocusOnAppearing);
    wrapped_text(text, colors::text);
    NoticeResult result;
    bool is_on_button = false;
    if (button != nullptr) {
        // At the right, so that a click in the corner of the view, where the eye looks first, only dismisses.
        const float button_width = text_size(button).x + 2 * ImGui::GetStyle().FramePadding.x;
        const float room = ImGui::GetContentRegionAvail().x - button_width;
        if (room > 0) ImGui::SetCursorPosX(ImGui::GetCursorPosX() + room);
        result.pressed = ImGui::Button(button);
        is_on_button = ImGui::IsItemHovered() || ImGui::IsItemActive();
    }
    result.pointed_at = ImGui::IsWindowHovered(ImGuiHoveredFlags_AllowWhenBlockedByActiveItem);
    result.dismissed = result.pressed ||
                       (result.pointed_at && !is_on_button && ImGui::IsMouseClicked(ImGuiMouseButton_Left));
    ImGui::End();
    ImGui::PopStyleColor();
    ImGui::PopStyleVar();
    ImGui::PopFont();
    return result;
}

}  // namespace interleaf
