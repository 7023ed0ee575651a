#include "ui/keys_panel.h"

#include <algorithm>

#include <fmt/format.h>
#include <imgui.h>

#include "render/palette.h"
#include "ui/number_text.h"
#include "ui/style.h"

namespace interleaf {

void keys_panel(std::span<const KeyRow> keys, const Weights& weights) {
    const float width = ImGui::GetContentRegionAvail().x;
    const float levels_right = width;
    const float leaves_right = width - scaled(56);
    const auto right_text = [](glm::vec2 corner, float right, ImU32 color, std::string_view text) {
        const float text_width = text_size(text).x;
        draw_text({corner.x + right - text_width, corner.y}, text_width + 1, color, text);
    };

    glm::vec2 corner = from_imgui(ImGui::GetCursorScreenPos());
    ImGui::PushFont(small_font());
    right_text(corner, leaves_right, colors::dim_text, "leaves");
    right_text(corner, levels_right, colors::dim_text, "levels");
    ImGui::PopFont();
    heading("Keys");
    for (std::size_t key = 0; key < keys.size(); ++key) {
        const bool active = std::ranges::find(weights, key, &Weight::key) != weights.end();
        const ImU32 text = active ? colors::text : colors::dim_text;
        corner = from_imgui(ImGui::GetCursorScreenPos());
        const float height = ImGui::GetTextLineHeight();
        const float indent = scaled(16);
        ImGui::GetWindowDrawList()->AddCircleFilled({corner.x + scaled(5), corner.y + height / 2 + 1},
                                                    scaled(4),
                                                    to_color(key_color(key), active ? 1.0F : 0.45F));
        const std::string leaves = grouped(keys[key].leaves);
        draw_text({corner.x + indent, corner.y}, leaves_right - indent - text_size(leaves).x - scaled(8),
                  text, keys[key].name);
        right_text(corner, leaves_right, text, leaves);
        right_text(corner, levels_right, text, fmt::format("{}", keys[key].deepest));
        ImGui::Dummy({width, height});
    }
}

}  // namespace interleaf
