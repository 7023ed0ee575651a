#include "ui/panels/weights_panel.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>

#include <fmt/core.h>
#include <imgui.h>

#include "render/palette.h"
#include "ui/widgets/section.h"
#include "ui/widgets/short_name.h"
#include "ui/widgets/style.h"

namespace interleaf {

namespace {

/// A family with more keys shows only the active ones.
constexpr std::size_t max_rows = 12;

/// Three decimals, and no minus sign before zero.
std::string weight_text(double weight) {
    return fmt::format("{:.3f}", std::abs(weight) < 0.0005 ? 0.0 : weight);
}

}  // namespace

void weights_panel(const Family& family, const Weights& weights) {
    const bool is_long = family.keys.size() > max_rows;
    const std::string count =
        is_long ? fmt::format("{} of {}", weights.size(), family.keys.size()) : std::string();
    if (!section("Weights", count,
                 "The part of each key in the blend. A dash marks a key that is not active."))
        return;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float width = ImGui::GetContentRegionAvail().x;
    const float name_width = std::round(width * 0.38F);
    const float number_width = text_size("-0.000").x;
    for (std::size_t key = 0; key < family.keys.size(); ++key) {
        const auto weight = std::ranges::find(weights, key, &Weight::key);
        const bool active = weight != weights.end();
        if (is_long && !active) continue;
        const ImU32 text = active ? colors::text : colors::dim_text;
        const glm::vec2 corner = from_imgui(ImGui::GetCursorScreenPos());
        const float height = ImGui::GetTextLineHeight();

        draw_name(corner, name_width - scaled(8), text, family.keys[key].name);
        const Rect bar{corner.x + name_width, corner.y + std::round(height * 0.3F),
                       width - name_width - number_width - scaled(8), std::round(height * 0.5F)};
        list.AddRectFilled({bar.x, bar.y}, {bar.right(), bar.bottom()}, colors::well, scaled(2));
        if (active && weight->value > 0) {
            const float part = std::min(static_cast<float>(weight->value), 1.0F);
            list.AddRectFilled({bar.x, bar.y}, {bar.x + part * bar.width, bar.bottom()},
                               to_color(key_color(key)), scaled(2));
        }
        const std::string number = active ? weight_text(weight->value) : "–";
        draw_text({corner.x + width - text_size(number).x, corner.y}, number_width, text, number);
        ImGui::Dummy({width, height});
    }
}

}  // namespace interleaf
