#include "ui/panels/comparison_panel.h"

#define GLFW_INCLUDE_NONE

#include <algorithm>
#include <array>
#include <cmath>

#include <GLFW/glfw3.h>
#include <fmt/core.h>
#include <imgui.h>

#include "ui/widgets/choice.h"
#include "ui/widgets/command_keys.h"
#include "ui/widgets/modal.h"
#include "ui/widgets/scale_legend.h"
#include "ui/widgets/short_name.h"
#include "ui/widgets/style.h"
#include "ui/widgets/tooltip.h"

namespace interleaf {

namespace {

constexpr const char* mesh_colorings[] = {"Distance", "Plain"};
constexpr const char* back = "Back to document";

/// From this width on, the legend stands beside the figures.
constexpr float wide = 900;

float figure_width() {
    return scaled(118);
}

float figures_height() {
    return ImGui::GetTextLineHeight() + scaled(2) + ImGui::GetFontSize();
}

/// Height of the legend with its heading.
float legend_height() {
    ImGui::PushFont(small_font());
    const float line = ImGui::GetTextLineHeight();
    ImGui::PopFont();
    return 2 * line + scaled(18) + ImGui::GetStyle().ItemSpacing.y;
}

/// Draws a number below its name.
void figure(glm::vec2 corner, std::string_view name, const std::string& value) {
    ImGui::PushFont(small_font());
    const float line = ImGui::GetTextLineHeight();
    draw_text(corner, figure_width() - scaled(8), colors::dim_text, name);
    ImGui::PopFont();
    draw_text({corner.x, corner.y + line + scaled(2)}, figure_width() - scaled(8), colors::text, value);
}

void show_figures(const ComparisonShown& shown) {
    glm::vec2 corner = from_imgui(ImGui::GetCursorScreenPos());
    const auto next = [&](std::string_view name, const std::string& value) {
        figure(corner, name, value);
        corner.x += figure_width();
    };
    next("Hausdorff distance", fmt::format("{:.3g} %", shown.hausdorff));
    next("Root mean square", fmt::format("{:.3g} %", shown.root_mean_square));
    next("Least angle", fmt::format("{:.3g}\u00b0", shown.min_angle));
    next("Flipped leaves", fmt::format("{}", shown.flipped_leaves));
    ImGui::Dummy({4 * figure_width(), figures_height()});
    tooltip(
        "The largest and the mean distance between key and mesh, as parts of the box diagonal;\n"
        "the smallest angle of a leaf; leaves that the fit has turned over");
}

void choose_pair(const ComparisonShown& shown, float width, std::size_t& chosen) {
    ImGui::SetNextItemWidth(width);
    if (!ImGui::BeginCombo("##pair", shown.names[shown.chosen].c_str()))
        return tooltip("The fitted key that is compared (Left, Right)");
    for (std::size_t pair = 0; pair < shown.names.size(); ++pair) {
        const glm::vec2 corner = from_imgui(ImGui::GetCursorScreenPos());
        // Draw the name by hand: Dear ImGui does not show the part of a label after "##".
        ImGui::PushID(static_cast<int>(pair));
        if (ImGui::Selectable("", pair == shown.chosen)) chosen = pair;
        draw_name(corner, ImGui::GetItemRectSize().x, colors::text, shown.names[pair]);
        ImGui::PopID();
    }
    ImGui::EndCombo();
}

void show_legend(const ColorScale& scale) {
    heading("Distance, % of the box diagonal");
    scale_legend(scale);
}

void read_keys(const ComparisonShown& shown, std::size_t& chosen) {
    const std::size_t count = shown.names.size();
    if (is_key_pressed(GLFW_KEY_LEFT, KeyRepeat::yes)) chosen = (chosen + count - 1) % count;
    if (is_key_pressed(GLFW_KEY_RIGHT, KeyRepeat::yes)) chosen = (chosen + 1) % count;
}

}  // namespace

float comparison_panel_height(float width) {
    const float spacing = ImGui::GetStyle().ItemSpacing.y;
    const float one_row = 2 * ImGui::GetStyle().WindowPadding.y + ImGui::GetFrameHeight() + spacing;
    return width >= scaled(wide) ? one_row + std::max(figures_height(), legend_height()) + 2 * spacing
                                 : one_row + figures_height() + legend_height() + 3 * spacing;
}

ComparisonResult comparison_panel(const Rect& rect, const ComparisonShown& shown, bool takes_keyboard) {
    ComparisonResult result{.chosen = shown.chosen, .has_colors = shown.has_colors};
    begin_panel("comparison", rect);
    const float room = ImGui::GetContentRegionAvail().x;
    if (shown.names.size() > 1) {
        choose_pair(shown, std::min(scaled(200), room * 0.34F), result.chosen);
        ImGui::SameLine();
    }
    const std::string colors =
        with_keys("Color each surface by its distance to the other one", {"Next coloring"});
    const std::string plain = with_keys("Show both surfaces in one color", {"Next coloring"});
    const std::array<const char*, 2> tips{colors.c_str(), plain.c_str()};
    result.has_colors = choice("coloring", mesh_colorings, shown.has_colors ? 0 : 1, scaled(170), tips) == 0;
    const float button = modal_button_width(back);
    ImGui::SameLine(ImGui::GetWindowWidth() - ImGui::GetStyle().WindowPadding.x - button);
    result.is_over = modal_button({.label = back, .width = button, .is_main = true});
    tooltip(with_keys("Show the document again", {"Dismiss"}));
    ImGui::Spacing();
    show_figures(shown);
    if (shown.has_colors) {
        const bool is_beside = rect.width >= scaled(wide);
        if (is_beside) ImGui::SameLine(room - std::min(scaled(420), room - 4 * figure_width() - scaled(40)));
        ImGui::BeginGroup();
        show_legend(shown.scale);
        ImGui::EndGroup();
    }
    if (takes_keyboard) read_keys(shown, result.chosen);
    end_panel();
    return result;
}

}  // namespace interleaf
