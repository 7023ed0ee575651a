#include "ui/dialogs/progress_dialog.h"

#define GLFW_INCLUDE_NONE

#include <algorithm>
#include <cmath>

#include <GLFW/glfw3.h>
#include <fmt/core.h>
#include <imgui.h>

#include "ui/widgets/modal.h"
#include "ui/widgets/style.h"

namespace interleaf {

std::string time_left(double part, double seconds) {
    constexpr double min_seconds = 1;
    constexpr double min_part = 0.02;
    if (seconds < min_seconds || part < min_part) return "";
    const double left = std::ceil(seconds * (1 - part) / part);
    return left < 90 ? fmt::format("about {:.0f} s left", left)
                     : fmt::format("about {:.0f} min left", std::ceil(left / 60));
}

bool progress_dialog(const ProgressShown& shown, const Rect& area, bool closing) {
    bool cancelled = false;
    const float width = std::min(scaled(440), area.width - 2 * scaled(12));
    const float line = ImGui::GetTextLineHeightWithSpacing();
    const float height = 2 * scaled(14) + 2 * line + 3 * ImGui::GetStyle().ItemSpacing.y + scaled(8) +
                         ImGui::GetFrameHeightWithSpacing();
    if (!begin_modal("progress", area, {width, height})) return false;
    ImGui::TextUnformatted(shown.title.c_str());
    const glm::vec2 corner = from_imgui(ImGui::GetCursorScreenPos());
    const float room = ImGui::GetContentRegionAvail().x;
    const std::string left = time_left(shown.part, shown.seconds);
    const float left_width = text_size(left).x;
    draw_text(corner, room - left_width - scaled(12), colors::dim_text, shown.stage);
    draw_text({corner.x + room - left_width, corner.y}, left_width + 1, colors::dim_text, left);
    const float top = corner.y + line;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float done = room * static_cast<float>(std::clamp(shown.part, 0.0, 1.0));
    const float round = scaled(3);
    list.AddRectFilled({corner.x, top}, {corner.x + room, top + 2 * round}, colors::well, round);
    if (done > 2 * round)
        list.AddRectFilled({corner.x, top}, {corner.x + done, top + 2 * round}, colors::accent, round);
    ImGui::Dummy({0, line + 2 * round + ImGui::GetStyle().ItemSpacing.y});
    const float button = modal_button_width("Cancel");
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + room - button);
    cancelled = modal_button({.label = "Cancel", .width = button});
    cancelled |= is_key_pressed(GLFW_KEY_ESCAPE);
    end_modal(closing);
    return cancelled;
}

}  // namespace interleaf
