#include "ui/panels/key_picker.h"

#include <algorithm>
#include <vector>

#include <imgui.h>

#include "ui/widgets/row_clipper.h"
#include "ui/widgets/short_name.h"
#include "ui/widgets/style.h"

namespace interleaf {

namespace {

/// Longest list that does not scroll, in rows.
constexpr float max_picker_rows = 14;

/// The keys that are not active.
std::vector<std::size_t> offered_keys(const Family& family, const Weights& weights) {
    std::vector<std::size_t> offered;
    for (std::size_t key = 0; key < family.keys.size(); ++key)
        if (std::ranges::find(weights, key, &Weight::key) == weights.end()) offered.push_back(key);
    return offered;
}

}  // namespace

std::optional<std::size_t> key_picker(const char* label, const Family& family, const Weights& weights,
                                      float width) {
    std::optional<std::size_t> chosen;
    static constexpr const char* popup = "pick a key";
    if (ImGui::Button(label, {width, 0})) ImGui::OpenPopup(popup);
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("Add another key to the blend, with weight 0");
    ImGui::SetNextWindowSize({scaled(240), 0});
    if (!ImGui::BeginPopup(popup)) return chosen;
    const std::vector<std::size_t> offered = offered_keys(family, weights);
    const float row = ImGui::GetTextLineHeightWithSpacing();
    const float shown = row * std::min(static_cast<float>(offered.size()), max_picker_rows);
    if (offered.empty()) ImGui::TextDisabled("All keys are active");
    ImGui::BeginChild("keys", {0, std::max(shown, 1.0F)}, false, ImGuiWindowFlags_NavFlattened);
    RowClipper clipper(offered.size(), row);
    while (clipper.Step()) {
        for (auto i = static_cast<std::size_t>(clipper.DisplayStart);
             i < static_cast<std::size_t>(clipper.DisplayEnd); ++i) {
            ImGui::PushID(static_cast<int>(offered[i]));
            if (name_item(family.keys[offered[i]].name, scaled(216))) chosen = offered[i];
            ImGui::PopID();
        }
    }
    ImGui::EndChild();
    if (chosen) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
    return chosen;
}

}  // namespace interleaf
