#include "ui/panels/axes_widget.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <imgui.h>

#include "ui/widgets/style.h"

namespace interleaf {
namespace {

constexpr float axes_side = 84;  // at scale 1
constexpr float axes_gap = 8;    // from the view's corner
constexpr float axes_arm = 30;
constexpr float axis_end_radius = 8.5F;

/// A view along the axis whose end is nearer than this shows it as a point.
constexpr float seen_along = 0.9995F;

/// One end of an axis.
struct AxisEnd {
    glm::vec3 towards;
    const char* letter;  ///< null for a negative end
    glm::vec3 color;
    const char* tip;
};

constexpr glm::vec3 x_color(0.91F, 0.38F, 0.39F);
constexpr glm::vec3 y_color(0.52F, 0.76F, 0.33F);
constexpr glm::vec3 z_color(0.40F, 0.62F, 0.97F);

const std::array<AxisEnd, 6> axis_ends = {
    {{{1, 0, 0},
      "X",
      x_color,
      "Look along X, from its positive end.\nClick again to look from its negative end."},
     {{-1, 0, 0}, nullptr, x_color, "Look along X, from its negative end."},
     {{0, 1, 0},
      "Y",
      y_color,
      "Look along Y, from its positive end.\nClick again to look from its negative end."},
     {{0, -1, 0}, nullptr, y_color, "Look along Y, from its negative end."},
     {{0, 0, 1},
      "Z",
      z_color,
      "Look along Z, from its positive end.\nClick again to look from its negative end."},
     {{0, 0, -1}, nullptr, z_color, "Look along Z, from its negative end."}}};

/// The end and where it is drawn.
struct PlacedEnd {
    const AxisEnd* end;
    glm::vec2 at;  ///< screen coordinates
    float depth;   ///< towards the viewer
};

std::array<PlacedEnd, 6> placed_ends(glm::vec2 center, const glm::mat3& axes) {
    std::array<PlacedEnd, 6> placed{};
    for (std::size_t i = 0; i < axis_ends.size(); ++i) {
        const glm::vec3 seen = glm::transpose(axes) * axis_ends[i].towards;
        placed[i] = {&axis_ends[i], center + scaled(axes_arm) * glm::vec2(seen.x, -seen.y), seen.z};
    }
    std::ranges::sort(placed, {}, &PlacedEnd::depth);
    return placed;
}

/// The frontmost end under \p pointer; null if there is none.
const PlacedEnd* end_under(const std::array<PlacedEnd, 6>& placed, glm::vec2 pointer) {
    for (std::size_t i = placed.size(); i-- > 0;)
        if (glm::distance(placed[i].at, pointer) <= scaled(axis_end_radius + 1.5F)) return &placed[i];
    return nullptr;
}

void draw_axis_end(const PlacedEnd& placed, glm::vec2 center, bool is_pointed_at) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const AxisEnd& end = *placed.end;
    const float alpha = 0.62F + 0.38F * (0.5F + 0.5F * placed.depth);  // what is behind is fainter
    const ImU32 color = is_pointed_at ? to_color(glm::vec3(1)) : to_color(end.color, alpha);
    const ImVec2 at = to_imgui(placed.at);
    if (end.letter == nullptr) {
        list.AddCircleFilled(at, scaled(axis_end_radius - 1), to_color(0.45F * end.color, 0.85F * alpha));
        list.AddCircle(at, scaled(axis_end_radius - 1), color, 0, scaled(1.2F));
        return;
    }
    list.AddLine(to_imgui(center), at, color, scaled(2));
    list.AddCircleFilled(at, scaled(axis_end_radius), color);
    ImFont* const font = small_font();
    const float size = font->FontSize;
    const ImVec2 extent = font->CalcTextSizeA(size, 1e6F, 0, end.letter);
    list.AddText(font, size, {std::round(at.x - extent.x / 2), std::round(at.y - extent.y / 2)},
                 to_color(glm::vec3(0.05F)), end.letter);
}

}  // namespace

std::optional<Rect> axes_place(const Rect& view) {
    const float size = scaled(axes_side);
    const float gap = scaled(axes_gap);
    if (view.width < 3 * size || view.height < 2.5F * size) return std::nullopt;
    return Rect{view.right() - size - gap, view.y + gap, size, size};
}

AxesResult axes_widget(const Rect& view, const glm::mat3& axes, const char* window) {
    AxesResult result;
    const std::optional<Rect> place = axes_place(view);
    if (!place) return result;
    const glm::vec2 center(place->x + place->width / 2, place->y + place->height / 2);
    const auto placed = placed_ends(center, axes);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 0);
    ImGui::SetNextWindowBgAlpha(0);
    begin_panel(window, view);
    ImGui::SetCursorScreenPos({place->x, place->y});
    ImGui::InvisibleButton("axes", {place->width, place->height});
    const ImGuiIO& io = ImGui::GetIO();
    const PlacedEnd* const pointed = ImGui::IsItemHovered() && !ImGui::IsMouseDragging(ImGuiMouseButton_Left)
                                         ? end_under(placed, from_imgui(io.MousePos))
                                         : nullptr;
    if (ImGui::IsItemActive() && ImGui::IsMouseDragging(ImGuiMouseButton_Left))
        result.orbit = from_imgui(io.MouseDelta) / view.height;
    if (ImGui::IsItemDeactivated() && pointed != nullptr &&
        io.MouseDragMaxDistanceSqr[0] < io.MouseDragThreshold * io.MouseDragThreshold) {
        const glm::vec3 towards = pointed->end->towards;
        result.look_from = pointed->depth > seen_along ? -towards : towards;
    }
    if (ImGui::IsItemHovered())
        ImGui::GetWindowDrawList()->AddCircleFilled(to_imgui(center), place->width / 2,
                                                    to_color(glm::vec3(1), 0.07F));
    for (const PlacedEnd& end : placed) draw_axis_end(end, center, &end == pointed);
    end_panel();
    ImGui::PopStyleVar(2);
    if (pointed != nullptr) ImGui::SetTooltip("%s", pointed->end->tip);
    return result;
}

}  // namespace interleaf
