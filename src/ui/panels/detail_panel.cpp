#include "ui/panels/detail_panel.h"

#include <string>

#include <fmt/core.h>
#include <imgui.h>

#include "ui/widgets/number_text.h"
#include "ui/widgets/section.h"
#include "ui/widgets/style.h"

namespace interleaf {

namespace {

std::string part_in_words(const DetailChoice& choice, bool is_coarse) {
    if (choice.follows_camera) return "by camera";
    if (is_coarse) return "while moving";
    if (choice.detail >= 1) return "whole keys";
    return fmt::format("{:.0f} %", 100 * static_cast<double>(choice.detail));
}

}  // namespace

DetailChoice detail_panel(DetailChoice choice, std::size_t leaves, bool is_coarse) {
    if (!section("Detail", fmt::format("{}, {} leaves", part_in_words(choice, is_coarse), grouped(leaves)),
                 "How fine the keys are shown, from their roots to all of their leaves."))
        return choice;
    ImGui::BeginDisabled(choice.follows_camera);
    ImGui::SetNextItemWidth(-1);
    ImGui::SliderFloat("##detail", &choice.detail, 0, 1, "", ImGuiSliderFlags_AlwaysClamp);
    if (ImGui::IsItemHovered() && !ImGui::IsItemActive())
        ImGui::SetTooltip("From the roots to the whole keys (- and =)");
    ImGui::EndDisabled();
    ImGui::Checkbox("Follow the camera", &choice.follows_camera);
    if (ImGui::IsItemHovered())
        ImGui::SetTooltip("Finer where the surface is seen large and at its silhouette (Shift+C)");
    return choice;
}

}  // namespace interleaf
