#include "ui/panels/detail_panel.h"

#include <string>

#include <fmt/core.h>
#include <imgui.h>

#include "ui/widgets/number_text.h"
#include "ui/widgets/style.h"

namespace interleaf {

float detail_panel(float detail, std::size_t leaves) {
    const std::string part =
        detail < 1 ? fmt::format("{:.0f} %", 100 * static_cast<double>(detail)) : std::string("whole keys");
    heading("Detail", fmt::format("{}, {} leaves", part, grouped(leaves)));
    ImGui::SetNextItemWidth(-1);
    ImGui::SliderFloat("##detail", &detail, 0, 1, "", ImGuiSliderFlags_AlwaysClamp);
    if (ImGui::IsItemHovered() && !ImGui::IsItemActive())
        ImGui::SetTooltip("From the roots to the whole keys (- and =)");
    return detail;
}

}  // namespace interleaf
