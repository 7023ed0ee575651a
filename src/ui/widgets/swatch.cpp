#include "ui/widgets/swatch.h"

#include <cmath>

#include <imgui.h>

#include "ui/widgets/style.h"

namespace interleaf {

float swatch_side() {
    return scaled(10);
}

void draw_swatch(ImDrawList& list, glm::vec2 corner, float height, glm::vec3 color) {
    const float side = swatch_side();
    const ImVec2 from(corner.x, corner.y + std::round((height - side) / 2));
    const ImVec2 to(from.x + side, from.y + side);
    list.AddRectFilled(from, to, to_color(color), scaled(2));
    list.AddRect(from, to, colors::faint_line, scaled(2));
}

}  // namespace interleaf
