#include "ui/panels/status_line.h"

#include <algorithm>
#include <cmath>

#include <fmt/core.h>
#include <imgui.h>

#include "ui/widgets/number_text.h"
#include "ui/widgets/style.h"
#include "ui/widgets/tooltip.h"

namespace interleaf {

void status_line(const Rect& rect, const StatusFigures& figures) {
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {scaled(12), 0});
    ImGui::PushStyleColor(ImGuiCol_WindowBg, ImGui::GetStyleColorVec4(ImGuiCol_MenuBarBg));
    begin_panel("status", rect);
    ImGui::PushFont(small_font());
    std::string text = fmt::format(
        "{} {} active   ·   {} leaves{}   ·   {} vertices   ·   rebuilt in {:.1f} ms   ·   frame {:.1f} ms",
        figures.active_keys, figures.active_keys == 1 ? "key" : "keys", grouped(figures.leaves),
        figures.max_leaves ? fmt::format(" of at most {}", grouped(*figures.max_leaves)) : "",
        grouped(figures.vertices), figures.rebuild_milliseconds, figures.frame_milliseconds);
    if (!figures.report.empty()) text = fmt::format("{}   ·   {}", figures.report, text);
    if (figures.measured_part)
        text += fmt::format("   ·   measuring detail, {:.0f} %", 100 * *figures.measured_part);
    const glm::vec2 corner{rect.x + scaled(12),
                           rect.y + std::round((rect.height - ImGui::GetTextLineHeight()) / 2)};
    draw_text(corner, rect.width - 2 * scaled(12), colors::dim_text, text);
    ImGui::SetCursorScreenPos({rect.x, rect.y});
    ImGui::Dummy(
        {std::max(std::min(text_size(text).x + scaled(24), rect.width), 1.0F), std::max(rect.height, 1.0F)});
    ImGui::PopFont();
    tooltip(
        "Keys that have a part in the blend, the leaves and vertices of their union,\n"
        "and the time that the last union and the last frame took");
    end_panel();
    ImGui::PopStyleColor();
    ImGui::PopStyleVar();
}

}  // namespace interleaf
