#include "ui/dialogs/fit_tiles.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <imgui.h>

#include "ui/widgets/style.h"

namespace interleaf {

namespace {

/// Radii of the globe of roots and of the ends of its axes. The mesh is inside the unit ball.
constexpr float globe_radius = 1.04F;
constexpr float axis_radius = 1.15F;
constexpr float scene_radius = 1.24F;

/// Number of line segments per quarter of a great circle.
constexpr float parts_a_quarter = 16;

constexpr ImU32 front_edge = IM_COL32(255, 205, 110, 235);
constexpr ImU32 back_edge = IM_COL32(255, 205, 110, 80);

/// Draws points of space in a square of the window.
class Globe {
  public:
    Globe(ImDrawList& list, glm::vec2 corner, float side)
        : list_(list), corner_(corner), side_(side), eye_(tile_camera().eye()) {
        const Camera camera = tile_camera();
        to_clip_ = camera.projection(1) * camera.view();
    }

    glm::vec2 pixel(const glm::vec3& point) const {
        const glm::vec4 clip = to_clip_ * glm::vec4(point, 1);
        return corner_ + side_ * glm::vec2(0.5F + clip.x / clip.w / 2, 0.5F - clip.y / clip.w / 2);
    }

    /// Whether this point of the globe is on its visible side.
    bool is_in_front(const glm::vec3& point) const {
        return glm::dot(point, eye_) > globe_radius * globe_radius;
    }

    /// Draws the part of a great circle from \p from to \p to that is in front, or the part behind. Both ends
    /// are directions.
    void draw_arc(const glm::vec3& from, const glm::vec3& to, bool front) const {
        const float angle = std::acos(std::clamp(glm::dot(from, to), -1.0F, 1.0F));
        const float parts = std::max(std::ceil(angle / 1.5708F * parts_a_quarter), 1.0F);
        const auto at = [&](float n) {
            return globe_radius * glm::normalize((1 - n / parts) * from + n / parts * to);
        };
        for (float n = 0; n < parts; ++n) {
            const glm::vec3 begin = at(n);
            const glm::vec3 end = at(n + 1);
            if (is_in_front((begin + end) / 2.0F) == front)
                list_.AddLine(to_imgui(pixel(begin)), to_imgui(pixel(end)), front ? front_edge : back_edge,
                              scaled(front ? 1.5F : 1));
        }
    }

    /// Draws the part of an axis that sticks out of the globe at one end, with its letter.
    void draw_axis(int axis, bool is_chosen) const {
        glm::vec3 direction(0);
        direction[axis] = 1;
        const ImU32 color = is_chosen ? colors::accent : colors::dim_text;
        list_.AddLine(to_imgui(pixel(globe_radius * direction)), to_imgui(pixel(axis_radius * direction)),
                      color, scaled(is_chosen ? 2 : 1));
        const char letter[] = {"xyz"[axis], 0};
        const glm::vec2 at = pixel((axis_radius + 0.1F) * direction) - text_size(letter) / 2.0F;
        list_.AddText(to_imgui(glm::round(at)), color, letter);
    }

    /// Draws the part of an axis inside the globe. Only the axis of a turn is shown there.
    void draw_line(int axis) const {
        glm::vec3 direction(0);
        direction[axis] = 1;
        list_.AddLine(to_imgui(pixel(-globe_radius * direction)), to_imgui(pixel(globe_radius * direction)),
                      colors::accent, scaled(1));
    }

  private:
    ImDrawList& list_;
    glm::vec2 corner_;
    float side_;
    glm::vec3 eye_;
    glm::mat4 to_clip_{1};
};

/// Draws the globe of a tile. The globe is smaller than the tile if other meshes are larger.
/// \param corner  upper left corner of the tile
/// \param side  side of the tile
void draw_globe(const FitTile& tile, glm::vec2 corner, float side) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    ImGui::PushFont(small_font());
    const glm::vec2 center = Globe(list, corner, side).pixel(tile.center);
    side *= tile.radius;
    corner = center - glm::vec2(side / 2);
    const Globe globe(list, corner, side);
    for (const auto& [from, to] : tile.root_edges) globe.draw_arc(from, to, false);
    if (tile.is_turned) globe.draw_line(tile.axis);
    if (tile.picture != 0)
        list.AddImage(reinterpret_cast<ImTextureID>(  // NOLINT(performance-no-int-to-ptr)
                          static_cast<std::uintptr_t>(tile.picture)),
                      to_imgui(corner), {corner.x + side, corner.y + side});
    for (const auto& [from, to] : tile.root_edges) globe.draw_arc(from, to, true);
    for (int axis = 0; axis < 3; ++axis) globe.draw_axis(axis, axis == tile.axis);
    ImGui::PopFont();
}

void draw_fault(const std::string& fault, glm::vec2 corner, float side) {
    const float margin = scaled(8);
    ImGui::PushFont(small_font());
    ImGui::GetWindowDrawList()->AddText(ImGui::GetFont(), ImGui::GetFontSize(),
                                        {corner.x + margin, corner.y + margin}, colors::notice, fault.data(),
                                        fault.data() + fault.size(), side - 2 * margin);
    ImGui::PopFont();
}

/// \return whether it was clicked
bool draw_tile(const FitTile& tile, float side, bool is_selected, bool has_focus) {
    const glm::vec2 corner = from_imgui(ImGui::GetCursorScreenPos());
    const bool clicked = ImGui::InvisibleButton("tile", {side, tile_height(side)});
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 end{corner.x + side, corner.y + side};
    const float round = scaled(4);
    list.AddRectFilled(to_imgui(corner), end, colors::well, round);
    list.PushClipRect(to_imgui(corner), end, true);
    if (tile.fault.empty())
        draw_globe(tile, corner, side);
    else
        draw_fault(tile.fault, corner, side);
    list.PopClipRect();
    if (is_selected)
        list.AddRect(to_imgui(corner), end, has_focus ? colors::accent : colors::dim_text, round,
                     ImDrawFlags_None, scaled(1.5F));
    const float top = corner.y + side + scaled(4);
    draw_text({corner.x, top}, side, is_selected ? colors::text : colors::dim_text, tile.name);
    const float line = ImGui::GetTextLineHeight();
    ImGui::PushFont(small_font());
    draw_text({corner.x, top + line}, side, colors::dim_text, tile.remark);
    ImGui::PopFont();
    return clicked;
}

}  // namespace

Camera tile_camera() {
    Camera camera;
    camera.look_from(30, 20);
    const glm::vec3 corner(scene_radius);
    camera.view_all({{-corner, corner}, scene_radius}, 1);
    return camera;
}

float tile_height(float side) {
    ImGui::PushFont(small_font());
    const float small_line = ImGui::GetTextLineHeight();
    ImGui::PopFont();
    return side + scaled(4) + ImGui::GetTextLineHeight() + small_line;
}

FitTilesResult fit_tiles(std::span<const FitTile> tiles, std::size_t selected, std::size_t& first, float side,
                         bool has_focus) {
    FitTilesResult result;
    const float gap = scaled(12);
    const float arrow = scaled(22);
    const float room = ImGui::GetContentRegionAvail().x;
    const auto fitting = [&](float width) {
        return static_cast<std::size_t>(std::max((width + gap) / (side + gap), 1.0F));
    };
    const bool has_arrows = fitting(room) < tiles.size();
    const std::size_t count = has_arrows ? fitting(room - 2 * (arrow + gap)) : tiles.size();
    first = std::min(first, tiles.size() - count);
    first = std::clamp(first, selected + 1 > count ? selected + 1 - count : 0, selected);
    const float width = static_cast<float>(count) * (side + gap) - gap;
    const ImVec2 corner = ImGui::GetCursorPos();
    const float left = corner.x + std::round((room - width) / 2);
    const auto go_on = [&](const char* name, ImGuiDir direction, float x, std::size_t tile) {
        ImGui::SetCursorPos({x, corner.y + std::round((side - ImGui::GetFrameHeight()) / 2)});
        if (ImGui::ArrowButton(name, direction)) result.clicked = tile;
    };
    if (first > 0) go_on("before", ImGuiDir_Left, left - gap - arrow, first - 1);
    if (first + count < tiles.size()) go_on("behind", ImGuiDir_Right, left + width + gap, first + count);
    for (std::size_t n = 0; n < count; ++n) {
        const std::size_t tile = first + n;
        ImGui::SetCursorPos({left + static_cast<float>(n) * (side + gap), corner.y});
        ImGui::PushID(static_cast<int>(tile));
        const bool is_selected = tile == selected && tiles.size() > 1;
        if (draw_tile(tiles[tile], side, is_selected, has_focus)) result.clicked = tile;
        ImGui::PopID();
    }
    return result;
}

}  // namespace interleaf
