#include "ui/panels/inspector_panel.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include <fmt/core.h>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <imgui.h>

#include "hierarchy/level_map.h"
#include "ui/panels/axes_widget.h"
#include "ui/widgets/command_keys.h"
#include "ui/widgets/number_text.h"
#include "ui/widgets/style.h"
#include "ui/widgets/swatch.h"

namespace interleaf {
namespace {

struct StepButton {
    NodeStep step;
    const char* label;
    const char* description;
    const char* nowhere;  ///< why the step may lead nowhere
};

constexpr std::array<StepButton, 4> relatives = {{
    {NodeStep::parent, "Parent", "Go to the triangle that was bisected into this one and its sibling",
     "A root has no parent"},
    {NodeStep::sibling, "Sibling", "Go to the other child of the parent", "A root has no sibling"},
    {NodeStep::first_child, "Child 1", "Go to the first child (l, k, i)",
     "No active key bisects this triangle"},
    {NodeStep::second_child, "Child 2", "Go to the second child (l, i, j)",
     "No active key bisects this triangle"},
}};

constexpr const char* no_neighbor = "The boundary of the surface";
constexpr std::array<StepButton, 3> neighbors = {{
    {NodeStep::across_first, "Across 2–3",
     "Go to the neighbor across the refinement edge, from corner 2 to 3", no_neighbor},
    {NodeStep::across_second, "Across 3–1", "Go to the neighbor across the edge from corner 3 to 1",
     no_neighbor},
    {NodeStep::across_third, "Across 1–2", "Go to the neighbor across the edge from corner 1 to 2",
     no_neighbor},
}};

/// A row of buttons over the width of the panel.
void step_buttons(std::span<const StepButton> buttons, const InspectedNode& shown,
                  std::span<const std::string> shortcuts, std::optional<NodeStep>& step) {
    const float gap = scaled(4);
    const auto count = static_cast<float>(buttons.size());
    const float width = std::floor((ImGui::GetContentRegionAvail().x - gap * (count - 1)) / count);
    for (std::size_t button = 0; button < buttons.size(); ++button) {
        const auto& [way, label, description, nowhere] = buttons[button];
        const auto place = static_cast<std::size_t>(way);
        const bool leads = shown.steps.at(place).has_value();
        if (button > 0) ImGui::SameLine(0, gap);
        if (!leads) ImGui::BeginDisabled();
        if (ImGui::Button(label, {width, 0})) step = way;
        if (!leads) ImGui::EndDisabled();
        if (ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled))
            ImGui::SetTooltip("%s%s", leads ? description : nowhere,
                              leads ? fmt::format(" ({})", shortcuts[place]).c_str() : "");
    }
}

std::string title_of(const InspectedNode& shown) {
    const char* const kind = shown.state == NodeState::leaf       ? "Leaf"
                             : shown.state == NodeState::bisected ? "Bisected triangle"
                                                                  : "Inside a leaf";
    return fmt::format("{}, level {}", kind, shown.node.level);
}

/// \return whether the button that closes the panel was pressed
bool title_row(const InspectedNode& shown) {
    const float width = ImGui::GetContentRegionAvail().x;
    const glm::vec2 corner = from_imgui(ImGui::GetCursorScreenPos());
    const float side = ImGui::GetTextLineHeight() + scaled(4);
    draw_text({corner.x, corner.y + scaled(1)}, width - side - scaled(4), colors::text, title_of(shown));
    ImGui::SetCursorScreenPos({corner.x + width - side, corner.y});
    const bool is_over = ImGui::InvisibleButton("close", {side, side});
    const ImU32 ink = ImGui::IsItemHovered() ? colors::text : colors::dim_text;
    if (ImGui::IsItemHovered())
        ImGui::SetTooltip("%s", with_keys("Close the inspector", {"Dismiss"}).c_str());
    const float inset = scaled(6);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const glm::vec2 from{corner.x + width - side + inset, corner.y + inset};
    const glm::vec2 to{corner.x + width - inset, corner.y + side - inset};
    list.AddLine(to_imgui(from), to_imgui(to), ink, scaled(1.5F));
    list.AddLine({from.x, to.y}, {to.x, from.y}, ink, scaled(1.5F));
    return is_over;
}

/// The columns of a table of numbers, from the left end of the panel.
struct NumberColumns {
    float indent;
    float column;
    float remark;
    float width;
};

NumberColumns number_columns() {
    const float width = ImGui::GetContentRegionAvail().x;
    const float indent = scaled(18);
    const float column = std::floor(0.235F * (width - indent));
    return {indent, column, indent + 3 * column + scaled(8), width};
}

void draw_at_right(float right, float top, ImU32 color, const std::string& text) {
    draw_text({right - text_size(text).x, top}, text_size(text).x + 1, color, text);
}

/// A row of three numbers, with \p mark before it and \p remark after it.
void number_row(std::string_view mark, const std::array<std::string, 3>& numbers, const std::string& remark) {
    const NumberColumns columns = number_columns();
    const glm::vec2 corner = from_imgui(ImGui::GetCursorScreenPos());
    draw_text({corner.x + scaled(4), corner.y}, columns.indent, colors::dim_text, mark);
    for (std::size_t n = 0; n < numbers.size(); ++n)
        draw_at_right(corner.x + columns.indent + columns.column * static_cast<float>(n + 1), corner.y,
                      colors::text, numbers.at(n));
    if (!remark.empty()) draw_at_right(corner.x + columns.width, corner.y, colors::dim_text, remark);
    ImGui::Dummy({columns.width, ImGui::GetTextLineHeight()});
}

/// Decimals with which the largest coordinate has five digits; none where that takes too many.
std::optional<int> decimals_of(const InspectedNode& shown) {
    float largest = 0;
    const auto look_at = [&](const std::array<glm::vec3, 3>& corners) {
        for (const glm::vec3& corner : corners)
            for (int axis = 0; axis < 3; ++axis) largest = std::max(largest, std::abs(corner[axis]));
    };
    look_at(shown.blend);
    for (const InspectedKey& key : shown.keys) look_at(key.corners);
    if (!(largest > 1e-3F) || largest > 1e5F) return std::nullopt;
    return std::clamp(4 - static_cast<int>(std::floor(std::log10(largest))), 0, 6);
}

std::array<std::string, 3> coordinates(const glm::vec3& position, std::optional<int> decimals) {
    std::array<std::string, 3> numbers;
    for (int axis = 0; axis < 3; ++axis)
        numbers.at(static_cast<std::size_t>(axis)) = decimals
                                                         ? fmt::format("{:.{}f}", position[axis], *decimals)
                                                         : fmt::format("{:.3g}", position[axis]);
    return numbers;
}

std::string state_text(const InspectedKey& key) {
    switch (key.state) {
        case NodeState::leaf:
            return "leaf here";
        case NodeState::bisected:
            return fmt::format("bisected into {} leaves", grouped(key.leaf_count));
        case NodeState::inside_leaf:
            return fmt::format("inside a leaf of level {}", key.leaf_level);
    }
    return {};
}

const char* state_explained(NodeState state) {
    switch (state) {
        case NodeState::leaf:
            return "This key bisects this far, and no further.";
        case NodeState::bisected:
            return "This key bisects the triangle further.";
        case NodeState::inside_leaf:
            return "This key does not bisect this far. The level map gives the places of the corners in its "
                   "leaf.";
    }
    return "";
}

/// A line with the name of a surface and what it has at the node.
void surface_heading(std::string_view name, std::optional<glm::vec3> color, const std::string& remark) {
    const float width = ImGui::GetContentRegionAvail().x;
    const glm::vec2 corner = from_imgui(ImGui::GetCursorScreenPos());
    const float line = ImGui::GetTextLineHeight();
    if (color) draw_swatch(*ImGui::GetWindowDrawList(), corner, line, *color);
    const float indent = color ? scaled(18) : 0;
    const float remark_width = text_size(remark).x;
    draw_text({corner.x + indent, corner.y}, width - indent - remark_width - scaled(8), colors::text, name);
    draw_at_right(corner.x + width, corner.y, colors::dim_text, remark);
    ImGui::Dummy({width, line});
}

void blend_section(const InspectedNode& shown, std::optional<int> decimals) {
    const float length = glm::distance(shown.blend[1], shown.blend[2]);
    surface_heading("Blend", std::nullopt, fmt::format("refinement edge {:.3g}", length));
    if (ImGui::IsItemHovered())
        ImGui::SetTooltip(
            "The corners in the blend, and the length of the edge from corner 2 to 3, which\n"
            "bisection splits.");
    for (std::size_t corner = 0; corner < 3; ++corner)
        number_row(fmt::format("{}", corner + 1), coordinates(shown.blend.at(corner), decimals), {});
}

void key_section(const InspectedKey& key, std::optional<int> decimals) {
    surface_heading(key.name, key.color, state_text(key));
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s\n%s", key.name.c_str(), state_explained(key.state));
    for (std::size_t corner = 0; corner < 3; ++corner) {
        const Index vertex = key.vertices.at(corner);
        number_row(fmt::format("{}", corner + 1), coordinates(key.corners.at(corner), decimals),
                   vertex == no_index ? "" : fmt::format("v {}", vertex));
        if (ImGui::IsItemHovered())
            ImGui::SetTooltip("%s", vertex == no_index
                                        ? "No vertex of this key: a point of its leaf"
                                        : fmt::format("Vertex {} of this key", vertex).c_str());
    }
}

void level_map_section(const NodePath& node) {
    surface_heading(fmt::format("Level map to root {}", node.root), std::nullopt, "");
    if (ImGui::IsItemHovered())
        ImGui::SetTooltip(
            "Column c holds the barycentric coordinates of corner c in the root.\n"
            "The matrix takes coordinates in this triangle to coordinates in the root.");
    const glm::dmat3 map = level_map(node.path, node.level);
    for (int row = 0; row < 3; ++row)
        number_row(fmt::format("b{}", row + 1),
                   {dyadic_text(map[0][row]), dyadic_text(map[1][row]), dyadic_text(map[2][row])}, {});
}

/// Between the inspector and the borders of the view.
float margin_of_inspector() {
    return scaled(12);
}

float inspector_width(const Rect& view) {
    return std::min(scaled(300), view.width - 2 * margin_of_inspector());
}

/// The height of the brush's bar in the same corner, with the gap below it.
float brush_bar_height() {
    ImGui::PushFont(small_font());
    const float height = ImGui::GetFrameHeight() + scaled(18);
    ImGui::PopFont();
    return height;
}

}  // namespace

std::string path_text(const NodePath& node) {
    std::string digits;
    for (unsigned level = 0; level < node.level; ++level) {
        if (level > 0 && level % 4 == 0) digits += ' ';
        digits += (node.path >> level & 1) != 0 ? '1' : '0';
    }
    return digits.empty() ? "–" : digits;
}

std::string dyadic_text(double value) {
    constexpr int max_denominator = 4096;
    for (int denominator = 1; denominator <= max_denominator; denominator *= 2)
        if (const double numerator = value * denominator; numerator == std::floor(numerator))
            return denominator == 1 ? fmt::format("{:.0f}", numerator)
                                    : fmt::format("{:.0f}/{}", numerator, denominator);
    return fmt::format("{:.5g}", value);
}

bool is_at_left(glm::vec2 place, const Rect& view) {
    return place.x < view.x + inspector_width(view) + 2 * margin_of_inspector();
}

InspectorResult inspector_panel(const InspectedNode& shown, std::span<const std::string> shortcuts,
                                const Rect& view) {
    const float margin = margin_of_inspector();
    const float width = inspector_width(view);
    float top = view.y + margin + brush_bar_height();
    if (const auto axes = axes_place(view); shown.is_at_left && axes) top = axes->bottom() + margin;
    if (shown.is_at_left)
        ImGui::SetNextWindowPos({view.right() - margin, view.bottom() - margin}, ImGuiCond_Always, {1, 1});
    else
        ImGui::SetNextWindowPos({view.x + margin, top});
    ImGui::SetNextWindowSizeConstraints({width, 0}, {width, std::max(view.bottom() - top - margin, 1.0F)});
    ImGui::SetNextWindowBgAlpha(0.92F);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, scaled(6));
    ImGui::PushStyleColor(ImGuiCol_Border, ImGui::GetStyleColorVec4(ImGuiCol_Separator));
    ImGui::Begin("inspector", nullptr,
                 ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize |
                     ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoCollapse |
                     ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoNav |
                     ImGuiWindowFlags_NoFocusOnAppearing);
    InspectorResult result;
    result.is_over = title_row(shown);
    ImGui::PushFont(small_font());
    wrapped_text(fmt::format("root {}, path {}", shown.node.root, path_text(shown.node)), colors::dim_text);
    if (ImGui::IsItemHovered())
        ImGui::SetTooltip("The path has a digit per bisection: 0 for the first child, 1 for the second one.");
    ImGui::Spacing();
    step_buttons(relatives, shown, shortcuts, result.step);
    step_buttons(neighbors, shown, shortcuts, result.step);
    ImGui::Spacing();
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {ImGui::GetStyle().ItemSpacing.x, scaled(2)});
    const std::optional<int> decimals = decimals_of(shown);
    blend_section(shown, decimals);
    for (const InspectedKey& key : shown.keys) {
        ImGui::Dummy({0, scaled(2)});
        key_section(key, decimals);
    }
    ImGui::Dummy({0, scaled(2)});
    level_map_section(shown.node);
    ImGui::PopStyleVar();
    ImGui::PopFont();
    ImGui::End();
    ImGui::PopStyleColor();
    ImGui::PopStyleVar();
    return result;
}

}  // namespace interleaf
