#include "ui/panels/view_area.h"

#include <cmath>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <imgui.h>

#include "ui/widgets/style.h"

namespace interleaf {
namespace {

/// By how many degrees the pointer went about \p center, counterclockwise.
float turned_about(glm::vec2 center, const ImGuiIO& io) {
    const glm::vec2 now = from_imgui(io.MousePos) - center;
    const glm::vec2 before = now - from_imgui(io.MouseDelta);
    return glm::degrees(std::atan2(before.x * -now.y + before.y * now.x, glm::dot(before, now)));
}

}  // namespace

ViewInput view_area(const Rect& rect, const char* name) {
    ViewInput input;
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 0);
    ImGui::SetNextWindowBgAlpha(0);
    begin_panel(name, rect);
    if (rect.width >= 1 && rect.height >= 1) {
        ImGui::SetCursorScreenPos({rect.x, rect.y});
        mouse_area("surface", {rect.width, rect.height},
                   ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight |
                       ImGuiButtonFlags_MouseButtonMiddle);
        const ImGuiIO& io = ImGui::GetIO();
        input.pointer = from_imgui(io.MousePos);
        // In the frame of the press, the mouse delta also contains the movement before the press.
        if (ImGui::IsItemActive() && !ImGui::IsItemActivated()) {
            const bool pans = !ImGui::IsMouseDown(ImGuiMouseButton_Left) || io.KeyShift;
            input.turns_flat = io.KeyCtrl;
            if (io.KeyCtrl && ImGui::IsMouseDown(ImGuiMouseButton_Right))
                input.roll = turned_about({rect.x + rect.width / 2, rect.y + rect.height / 2}, io);
            else
                (pans ? input.pan : input.orbit) = from_imgui(io.MouseDelta) / rect.height;
        }
        // A second press that becomes a drag is no double-click.
        constexpr float farthest = 3;  // screen coordinates; the hand may shake
        const bool is_in_place = ImGui::IsItemDeactivated() &&
                                 ImGui::IsMouseReleased(ImGuiMouseButton_Left) &&
                                 io.MouseDragMaxDistanceSqr[ImGuiMouseButton_Left] <= farthest * farthest;
        const int presses = io.MouseClickedLastCount[ImGuiMouseButton_Left];
        input.clicked = is_in_place && presses == 1 && !io.KeyShift && !io.KeyCtrl;
        input.view_all = is_in_place && presses == 2;
        input.hovered = ImGui::IsItemHovered();
        input.pressed = ImGui::IsItemActivated() && ImGui::IsMouseClicked(ImGuiMouseButton_Left);
        input.pressed_again = input.pressed && presses == 2;
        input.held = ImGui::IsItemActive() && ImGui::IsMouseDown(ImGuiMouseButton_Left);
        input.pointed_at = ImGui::IsItemHovered() && !ImGui::IsAnyMouseDown();
        if (ImGui::IsItemHovered()) input.zoom = std::pow(1.12F, io.MouseWheel);
    }
    end_panel();
    ImGui::PopStyleVar(2);
    return input;
}

}  // namespace interleaf
