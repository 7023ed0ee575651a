#include "app/pictures/picture_arrows.h"

#include <algorithm>

#include <glm/geometric.hpp>
#include <glm/vec4.hpp>

#include "app/pictures/pixel_canvas.h"

namespace interleaf {
namespace {

constexpr glm::vec4 arrow_ink(0.96F, 0.97F, 0.98F, 1);
constexpr glm::vec4 arrow_rim(0.063F, 0.07F, 0.086F, 0.75F);

void draw_arrow(PixelCanvas& canvas, const Arrow& arrow, float scale, const glm::vec4& color, float width) {
    const float length = glm::distance(arrow.from, arrow.to);
    if (length < 1.5F * scale) return canvas.line(arrow.from, arrow.from, 2 * width, color);
    const glm::vec2 along = (arrow.to - arrow.from) / length;
    const glm::vec2 across(-along.y, along.x);
    const float head = std::min(6 * scale, 0.45F * length);
    const float rim = width / 4;
    const glm::vec2 neck = arrow.to - head * along;
    canvas.line(arrow.from, neck, width, color);
    canvas.triangle(arrow.to + 2 * rim * along, neck - rim * along + (0.5F * head + rim) * across,
                    neck - rim * along - (0.5F * head + rim) * across, color);
}

float arrow_scale(int width, int height) {
    constexpr float usual_side = 720;
    return std::max(1.0F, static_cast<float>(std::min(width, height)) / usual_side);
}

}  // namespace

float arrow_cell_of(int width, int height) {
    constexpr float usual_cell = 26;
    return usual_cell * arrow_scale(width, height);
}

void draw_arrows(std::span<std::uint8_t> rgba, int width, int height, std::span<const Arrow> arrows) {
    PixelCanvas canvas(rgba, width, height);
    const float scale = arrow_scale(width, height);
    for (const Arrow& arrow : arrows) {
        draw_arrow(canvas, arrow, scale, arrow_rim, 3 * scale);
        draw_arrow(canvas, arrow, scale, arrow_ink, 1.25F * scale);
    }
}

}  // namespace interleaf
