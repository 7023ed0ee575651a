#include "ui/widgets/value_label.h"

#include <algorithm>
#include <cmath>

#include <imgui.h>

#include "ui/widgets/style.h"
#include "ui/widgets/swatch.h"

namespace interleaf {

void value_label(glm::vec2 pointer, const Rect& area, glm::vec3 color, std::string_view text) {
    ImGui::PushFont(small_font());
    const glm::vec2 padding(scaled(8), scaled(4));
    const float indent = swatch_side() + scaled(6);
    const glm::vec2 size = text_size(text) + 2.0F * padding + glm::vec2(indent, 0);
    // Place the label to the right of the pointer and below it, if it fits there into the area.
    const glm::vec2 offset(scaled(14), scaled(16));
    const auto place = [](float at, float shift, float length, float begin, float end) {
        const float after = at + shift;
        return after + length <= end ? after : std::max(at - shift / 2 - length, begin);
    };
    const glm::vec2 corner(place(pointer.x, offset.x, size.x, area.x, area.right()),
                           place(pointer.y, offset.y, size.y, area.y, area.bottom()));
    ImDrawList& list = *ImGui::GetForegroundDrawList();
    list.AddRectFilled(to_imgui(corner), to_imgui(corner + size), colors::label, scaled(4));
    draw_swatch(list, {corner.x + padding.x, corner.y}, size.y, color);
    list.AddText(to_imgui(corner + padding + glm::vec2(indent, 0)), colors::text, text.data(),
                 text.data() + text.size());
    ImGui::PopFont();
}

}  // namespace interleaf
