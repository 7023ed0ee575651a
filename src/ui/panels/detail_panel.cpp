#include "ui/panels/detail_panel.h"

#include <string>

#include <fmt/core.h>
#include <imgui.h>

#include "ui/widgets/command_keys.h"
#include "ui/widgets/number_text.h"
#include "ui/widgets/section.h"
#include "ui/widgets/style.h"
#include "ui/widgets/tooltip.h"

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
    tooltip(with_keys("From the roots to the whole keys", {"Less detail", "More detail"}));
    ImGui::EndDisabled();
    ImGui::Checkbox("Follow the camera", &choice.follows_camera);
    tooltip(
        with_keys("Finer where the surface is seen large and at its silhouette", {"Detail follows camera"}));
    return choice;
}

}  // namespace interleaf
