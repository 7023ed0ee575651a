#include "ui/splitters.h"

#include <algorithm>

#include <imgui.h>

#include "ui/widgets/style.h"

namespace interleaf {

namespace {

/// Half the width of the strip that the pointer can take hold of, at scale 1.
constexpr float half_strip = 3;

struct Edge {
    const char* name;
    Rect line;  ///< of width or height 0
    bool is_upright;
};

enum class EdgeUse { none, drag, reset };

/// Shows one edge. Its window lies in front of the panels, and draws only while the pointer is at the edge.
EdgeUse use_edge(const Edge& edge) {
    const float half = scaled(half_strip);
    const Rect strip = edge.is_upright ? Rect{edge.line.x - half, edge.line.y, 2 * half, edge.line.height}
                                       : Rect{edge.line.x, edge.line.y - half, edge.line.width, 2 * half};
    if (strip.width < 1 || strip.height < 1) return EdgeUse::none;
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 0);
    ImGui::SetNextWindowPos({strip.x, strip.y});
    ImGui::SetNextWindowSize({strip.width, strip.height});
    // Unlike the window of a panel, this one comes to the front.
    ImGui::Begin(edge.name, nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoMove |
                     ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoNav |
                     ImGuiWindowFlags_NoFocusOnAppearing);
    ImGui::InvisibleButton("edge", {strip.width, strip.height});
    const bool is_held = ImGui::IsItemActive();
    if (is_held || ImGui::IsItemHovered()) {
        ImGui::SetMouseCursor(edge.is_upright ? ImGuiMouseCursor_ResizeEW : ImGuiMouseCursor_ResizeNS);
        const float thick = scaled(1);
        const Rect& line = edge.line;
        ImGui::GetWindowDrawList()->AddRectFilled(
            {line.x - (edge.is_upright ? thick : 0), line.y - (edge.is_upright ? 0 : thick)},
            {line.right() + (edge.is_upright ? thick : 0), line.bottom() + (edge.is_upright ? 0 : thick)},
            colors::accent);
        if (!is_held)
            ImGui::SetTooltip("Drag to change the size of the panel; double-click for the usual size");
    }
    EdgeUse use = is_held ? EdgeUse::drag : EdgeUse::none;
    if (ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) use = EdgeUse::reset;
    ImGui::End();
    ImGui::PopStyleVar(2);
    return use;
}

/// Applies the drag of \p edge to \p size.
/// \param wanted  the size, in screen coordinates, that brings the edge to the pointer
/// \return whether \p size may have changed
bool drag_edge(const Edge& edge, std::optional<float>& size, float wanted, float scale) {
    switch (use_edge(edge)) {
        case EdgeUse::drag:
            // The press alone moves nothing, so that a double click does not, either.
            if (!ImGui::IsMouseDragging(ImGuiMouseButton_Left, 1)) return false;
            size = std::max(wanted, 0.0F) / scale;
            return true;
        case EdgeUse::reset:
            size.reset();
            return true;
        case EdgeUse::none:
            break;
    }
    return false;
}

}  // namespace

std::optional<PanelSizes> splitters(const Layout& layout, const PanelSizes& sizes, float scale) {
    const glm::vec2 pointer = from_imgui(ImGui::GetIO().MousePos);
    PanelSizes wanted = sizes;
    bool is_used = false;
    if (const auto& left = layout.left)
        is_used |= drag_edge({"left edge", {left->right(), left->y, 0, left->height}, true}, wanted.left,
                             pointer.x - left->x, scale);
    const Rect& right = layout.right;
    is_used |= drag_edge({"right edge", {right.x, right.y, 0, right.height}, true}, wanted.right,
                         right.right() - pointer.x, scale);
    const Rect& timeline = layout.timeline;
    if (timeline.height > 0)
        is_used |= drag_edge({"timeline edge", {timeline.x, timeline.y, timeline.width, 0}, false},
                             wanted.timeline, timeline.bottom() - pointer.y, scale);
    return is_used && wanted != sizes ? std::optional(wanted) : std::nullopt;
}

}  // namespace interleaf
