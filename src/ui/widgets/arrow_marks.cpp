#include "ui/widgets/arrow_marks.h"

#include <algorithm>
#include <array>

#include <glm/geometric.hpp>
#include <imgui.h>

#include "ui/widgets/style.h"

namespace interleaf {

void arrow_mark(glm::vec2 from, glm::vec2 to) {
    constexpr ImU32 ink = IM_COL32(245, 247, 250, 255);
    constexpr ImU32 rim = IM_COL32(16, 18, 22, 190);
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    const float length = glm::distance(from, to);
    if (length < scaled(1.5F)) {
        list.AddCircleFilled(to_imgui(from), scaled(1.5F), rim);
        list.AddCircleFilled(to_imgui(from), scaled(1), ink);
        return;
    }
    const glm::vec2 along = (to - from) / length;
    const glm::vec2 across(-along.y, along.x);
    const float head = std::min(scaled(6), 0.45F * length);
    const glm::vec2 neck = to - head * along;
    const std::array<glm::vec2, 3> tip = {to, neck + 0.5F * head * across, neck - 0.5F * head * across};
    const auto draw = [&](ImU32 color, float width) {
        list.AddLine(to_imgui(from), to_imgui(neck), color, width);
        list.AddTriangleFilled(to_imgui(tip[0]), to_imgui(tip[1]), to_imgui(tip[2]), color);
        list.AddTriangle(to_imgui(tip[0]), to_imgui(tip[1]), to_imgui(tip[2]), color, width / 2);
    };
    draw(rim, scaled(3));
    draw(ink, scaled(1.25F));
}

}  // namespace interleaf
