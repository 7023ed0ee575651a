#include "ui/timeline/path_marks.h"

#include <algorithm>
#include <cstddef>
#include <optional>

#include <fmt/core.h>
#include <imgui.h>

#include "ui/widgets/style.h"

namespace interleaf {

namespace {

/// Distance between two marks, and half the width of one; at scale 1.
constexpr float point_distance = 9;
constexpr float half_mark = 5;

void show_point_menu(std::size_t place, TrackResult& result) {
    if (!ImGui::BeginPopup("point menu")) return;
    if (ImGui::MenuItem("Set time...")) result.asked_time = place;
    if (ImGui::MenuItem("Remove point")) result.removed = place;
    ImGui::EndPopup();
}

void show_mark(const TrackLayout& layout, const DomainPath& path, std::size_t place, const TimeScale& scale,
               const std::optional<TimeDrag>& held, TrackResult& result) {
    const PathPoint& point = path.points()[place];
    const float x = scale.pixel(point.time);
    const float half = scaled(half_mark);
    const float top = layout.names.y;
    ImGui::PushID(static_cast<int>(place));
    ImGui::SetCursorScreenPos({x - half, top});
    mouse_area("point", {2 * half, scaled(9)});
    const bool is_pointed = ImGui::IsItemHovered() || held;
    if (is_pointed) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
    if (ImGui::IsItemHovered() && !ImGui::IsItemActive())
        ImGui::SetTooltip("%s", fmt::format("Point {} of {}, {:.10g} s\nDrag to move it in time", place + 1,
                                            path.points().size(), point.time)
                                    .c_str());
    if (ImGui::IsItemActive()) result.drag = held ? *held : TimeDrag{place, scale.visible};
    ImGui::OpenPopupOnItemClick("point menu", ImGuiPopupFlags_MouseButtonRight);
    show_point_menu(place, result);
    ImGui::PopID();
    ImGui::GetWindowDrawList()->AddTriangleFilled({x - half + 1, top + scaled(7)},
                                                  {x + half - 1, top + scaled(7)}, {x, top + scaled(1)},
                                                  is_pointed ? colors::ink : colors::dim_text);
}

}  // namespace

void show_path_marks(const TrackLayout& layout, const DomainPath& path, const TimeScale& scale,
                     const TrackState& state, TrackResult& result) {
    const auto points = path.points();
    const auto first = std::ranges::lower_bound(points, scale.visible.begin, {}, &PathPoint::time);
    float last = -1e9F;
    for (auto place = static_cast<std::size_t>(first - points.begin()); place < points.size(); ++place) {
        if (points[place].time > scale.visible.end) break;
        const bool is_held = state.drag && state.drag->place == place;
        const float x = scale.pixel(points[place].time);
        if (x - last < scaled(point_distance) && !is_held) continue;
        last = x;
        show_mark(layout, path, place, scale, is_held ? state.drag : std::nullopt, result);
    }
}

}  // namespace interleaf
