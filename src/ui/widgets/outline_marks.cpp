#include "ui/widgets/outline_marks.h"

#include <algorithm>
#include <array>
#include <cstddef>

#include <glm/geometric.hpp>
#include <imgui.h>

#include "ui/widgets/style.h"

namespace interleaf {
namespace {

constexpr ImU32 outline_ink = IM_COL32(255, 214, 64, 255);
constexpr ImU32 refinement_ink = IM_COL32(255, 112, 58, 255);
constexpr ImU32 outline_rim = IM_COL32(14, 16, 20, 210);
constexpr ImU32 hidden_ink = IM_COL32(255, 214, 64, 84);
constexpr ImU32 hidden_refinement_ink = IM_COL32(255, 112, 58, 96);

void draw_line(const std::vector<glm::vec2>& points, ImU32 color, float width) {
    std::vector<ImVec2> placed;
    placed.reserve(points.size());
    for (const glm::vec2 point : points) placed.push_back(to_imgui(point));
    ImGui::GetBackgroundDrawList()->AddPolyline(placed.data(), static_cast<int>(placed.size()), color,
                                                ImDrawFlags_None, width);
}

/// The middle of the corners that are in front of the camera.
glm::vec2 middle_of(const Outline& outline) {
    glm::vec2 sum(0);
    float count = 0;
    for (const auto& corner : outline.corners)
        if (corner) {
            sum += *corner;
            ++count;
        }
    return count > 0 ? sum / count : sum;
}

void draw_numbers(const Outline& outline) {
    static constexpr std::array<const char*, 3> numbers = {"1", "2", "3"};
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    const glm::vec2 middle = middle_of(outline);
    ImGui::PushFont(small_font());
    for (std::size_t corner = 0; corner < numbers.size(); ++corner) {
        if (!outline.corners.at(corner)) continue;
        const glm::vec2 outward = *outline.corners.at(corner) - middle;
        const float length = glm::length(outward);
        const glm::vec2 direction = length > 0 ? outward / length : glm::vec2(0, -1);
        const glm::vec2 center = *outline.corners.at(corner) + scaled(16) * direction;
        const glm::vec2 size = text_size(numbers.at(corner));
        list.AddCircleFilled(to_imgui(center), scaled(9), outline_rim);
        list.AddText(to_imgui(center - size / 2.0F), outline_ink, numbers.at(corner));
    }
    ImGui::PopFont();
}

}  // namespace

Outline in_window(Outline outline, glm::vec2 corner, float density) {
    const auto placed = [&](glm::vec2 pixel) { return corner + pixel / density; };
    for (OutlineLine& line : outline.lines) std::ranges::transform(line.points, line.points.begin(), placed);
    for (auto& each : outline.corners)
        if (each) each = placed(*each);
    return outline;
}

void outline_mark(const Outline& outline, const Rect& area, bool has_numbers) {
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    list.PushClipRect({area.x, area.y}, {area.right(), area.bottom()}, true);
    for (const OutlineLine& line : outline.lines)
        if (line.is_hidden)
            draw_line(line.points, line.is_refinement_edge ? hidden_refinement_ink : hidden_ink,
                      scaled(1.5F));
    for (const OutlineLine& line : outline.lines)
        if (!line.is_hidden) draw_line(line.points, outline_rim, scaled(5));
    for (const OutlineLine& line : outline.lines)
        if (!line.is_hidden)
            draw_line(line.points, line.is_refinement_edge ? refinement_ink : outline_ink, scaled(2.5F));
    if (has_numbers) draw_numbers(outline);
    list.PopClipRect();
}

}  // namespace interleaf
