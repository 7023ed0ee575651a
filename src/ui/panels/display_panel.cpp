#include "ui/panels/display_panel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <vector>

#include <fmt/core.h>
#include <imgui.h>

#include "render/surface_values.h"
#include "ui/panels/field_panel.h"
#include "ui/widgets/choice.h"
#include "ui/widgets/command_keys.h"
#include "ui/widgets/legend_text.h"
#include "ui/widgets/scale_legend.h"
#include "ui/widgets/section.h"
#include "ui/widgets/short_name.h"
#include "ui/widgets/style.h"
#include "ui/widgets/swatch.h"
#include "ui/widgets/tooltip.h"

namespace interleaf {

namespace {

/// Shows the colorings in rows.
void coloring_choice(Coloring& value, bool has_fields) {
    const std::vector<Coloring> all = colorings(has_fields);
    const std::size_t in_row = all.size() % 3 == 0 ? 3 : 4;
    for (std::size_t begin = 0; begin < all.size(); begin += in_row) {
        const auto row = std::span(all).subspan(begin, std::min(in_row, all.size() - begin));
        std::vector<const char*> labels;
        std::vector<const char*> tips;
        labels.reserve(row.size());
        tips.reserve(row.size());
        for (const Coloring coloring : row) {
            labels.push_back(label_of(coloring));
            tips.push_back(explanation_of(coloring));
        }
        const auto chosen = static_cast<std::size_t>(std::ranges::find(row, value) - row.begin());
        const float width = ImGui::GetContentRegionAvail().x;
        const std::size_t now = choice(labels.front(), labels, chosen, width, tips);
        if (now < row.size()) value = row[now];
    }
}

/// A check box in one of two columns.
void check(const char* label, bool& value, const std::string& tip, bool is_second = false) {
    if (is_second) {
        const float left = ImGui::GetStyle().WindowPadding.x;
        const float column = (ImGui::GetContentRegionAvail().x + ImGui::GetStyle().ItemSpacing.x) / 2;
        ImGui::SameLine(left + std::round(column));
    }
    // Check boxes stand close together, so that the legend below them has room.
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {scaled(2), scaled(1)});
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {ImGui::GetStyle().ItemSpacing.x, scaled(3)});
    ImGui::Checkbox(label, &value);
    ImGui::PopStyleVar(2);
    tooltip(tip);
}

void choose_material(Display& display) {
    ImGui::SetNextItemWidth(-1);
    const bool is_open = ImGui::BeginCombo("##material", label_of(display.material));
    if (!is_open) return tooltip(with_keys("What a plain surface looks to be made of", {"Next material"}));
    for (const Material material : materials()) {
        if (!ImGui::Selectable(label_of(material), material == display.material)) continue;
        display.material = material;
        display.coloring = Coloring::plain;
    }
    ImGui::EndCombo();
}

/// The number below each swatch for which there is room.
void level_ticks(glm::vec2 corner, const LevelRange& levels, float step) {
    ImGui::PushFont(small_font());
    const float room = text_size("00").x + scaled(5);
    const auto every = static_cast<unsigned>(std::max(std::ceil(room / step), 1.0F));
    for (unsigned level = levels.min; level <= levels.max; ++level) {
        if ((level - levels.min) % every != 0) continue;
        const std::string text = fmt::format("{}", level);
        const float middle = corner.x + (static_cast<float>(level - levels.min) + 0.5F) * step;
        draw_text({std::round(middle - text_size(text).x / 2), corner.y}, room, colors::dim_text, text);
    }
    ImGui::Dummy({1, ImGui::GetTextLineHeight()});
    ImGui::PopFont();
}

void level_legend(const LevelRange& levels) {
    const glm::vec2 corner = from_imgui(ImGui::GetCursorScreenPos());
    const float width = ImGui::GetContentRegionAvail().x;
    const float height = scaled(10);
    const unsigned count = levels.max - levels.min + 1;
    const auto edge = [&](unsigned step) {
        return corner.x + std::round(width * static_cast<float>(step) / static_cast<float>(count));
    };
    for (unsigned step = 0; step < count; ++step) {
        ImGui::GetWindowDrawList()->AddRectFilled({edge(step), corner.y}, {edge(step + 1), corner.y + height},
                                                  to_color(level_color(levels.min + step, levels)));
    }
    ImGui::Dummy({width, height});
    tooltip("Level: the number of bisections above a leaf. Levels of many leaves differ more in color.");
    level_ticks({corner.x, corner.y + height + scaled(1)}, levels, width / static_cast<float>(count));
}

/// A line with a square of \p color before it, and a tooltip.
void swatch_row(glm::vec3 color, const std::string& text, const std::string& tooltip) {
    const float width = ImGui::GetContentRegionAvail().x;
    const float indent = scaled(18);
    const glm::vec2 corner = from_imgui(ImGui::GetCursorScreenPos());
    const float height = ImGui::GetTextLineHeight();
    draw_swatch(*ImGui::GetWindowDrawList(), corner, height, color);
    draw_text({corner.x + indent, corner.y}, width - indent, colors::text, text);
    ImGui::Dummy({width, height});
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", tooltip.c_str());
}

/// The legend shows at least so many origins. Many active keys can make thousands.
constexpr std::size_t min_shown_origins = 6;

/// Lines of text below the cursor for which the panel, unscrolled, has room.
std::size_t lines_in_view() {
    const float bottom =
        ImGui::GetWindowPos().y + ImGui::GetWindowHeight() - ImGui::GetStyle().WindowPadding.y;
    const float top = ImGui::GetCursorScreenPos().y + ImGui::GetScrollY();
    const float lines =
        (bottom - top + ImGui::GetStyle().ItemSpacing.y) / ImGui::GetTextLineHeightWithSpacing();
    return static_cast<std::size_t>(std::max(lines, 0.0F));
}

/// One row of the legend. A long name is cut; the tooltip has all of it.
void origin_row(KeySet origin, const Legend& legend, float width) {
    const float indent = scaled(16);
    const glm::vec2 corner = from_imgui(ImGui::GetCursorScreenPos());
    const float height = ImGui::GetTextLineHeight();
    draw_swatch(*ImGui::GetWindowDrawList(), corner, height, origin_color(origin, legend.active_keys));
    const std::string name = origin_name(origin, legend.active_names);
    draw_text({corner.x + indent, corner.y}, width - indent, colors::text, shortened(name, width - indent));
    ImGui::Dummy({width, height});
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("Leaves that are bisected this far in %s", name.c_str());
}

/// Names the origins that have no row of their own.
void other_origins(std::span<const KeySet> origins, const Legend& legend) {
    constexpr std::size_t max_named = 20;
    wrapped_text(fmt::format("and {} other sets of keys", origins.size()), colors::dim_text);
    if (!ImGui::IsItemHovered()) return;
    std::string names;
    for (const KeySet origin : origins.first(std::min(origins.size(), max_named)))
        names += fmt::format("{}{}", names.empty() ? "" : "\n", origin_name(origin, legend.active_names));
    ImGui::SetTooltip("%s%s", names.c_str(), origins.size() > max_named ? "\n…" : "");
}

/// As many origins as the panel shows without scrolling: in two columns if they are many.
void origin_legend(const Legend& legend) {
    constexpr std::size_t long_from = 5;
    ImGui::PushFont(small_font());
    const std::size_t count = legend.origins.size();
    const std::size_t lines = lines_in_view();
    const std::size_t fitting = count <= 2 * lines ? count : 2 * (std::max<std::size_t>(lines, 1) - 1);
    const std::size_t shown = std::min(count, std::max(fitting, min_shown_origins));
    const bool has_columns = shown >= long_from;
    const float gap = ImGui::GetStyle().ItemSpacing.x;
    const float room = ImGui::GetContentRegionAvail().x;
    const float width = has_columns ? std::floor((room - gap) / 2) : room;
    for (std::size_t row = 0; row < shown; ++row) {
        if (has_columns && row % 2 == 1) ImGui::SameLine();
        origin_row(legend.origins[row], legend, width);
    }
    if (shown < count) other_origins(legend.origins.subspan(shown), legend);
    ImGui::PopFont();
}

/// The shares that occur on the surface.
void common_legend(const Legend& legend) {
    ImGui::PushFont(small_font());
    for (const auto& [share, text, explanation] : share_meanings(legend.origins, legend.active_keys.size()))
        swatch_row(common_color(share), text, explanation);
    ImGui::PopFont();
}

/// Offers to keep the shown range, and to edit its ends.
void keep_range(Display& display, const ColorScale& shown) {
    const bool was_kept = display.kept_range().has_value();
    bool is_kept = was_kept;
    check("Lock range", is_kept, "Keeps this range. Otherwise the range suits the active keys.");
    if (!is_kept && was_kept) display.measured_range.reset();
    if (is_kept && !was_kept) display.measured_range = {display.coloring, shown.range};
    if (!is_kept) return;
    // Right after a click on another coloring, the shown range is still that of the previous coloring.
    ColorScale scale = shown;
    scale.range = display.measured_range->range;
    edit_range(scale);
    display.measured_range->range = scale.range;
}

void measured_legend(Display& display, const Legend& legend) {
    const Coloring coloring = display.coloring;
    const std::string first = legend.active_names.empty() ? "" : legend.active_names.front();
    const std::string text = coloring == Coloring::angle       ? "Smallest angle of each leaf, degrees"
                             : coloring == Coloring::curvature ? "Mean curvature"
                                                               : fmt::format("Distance from {}", first);
    const char* const tooltip =
        coloring == Coloring::angle ? "0 for a leaf of no area, 60 for one with equal sides."
        : coloring == Coloring::curvature
            ? "Half the sum of the principal curvatures, above 0 where the surface bulges outwards. The\n"
              "range covers 95 % of the vertices of the active keys."
            : "How far the blend has moved each vertex from its place in the first active key. The range\n"
              "covers all active keys.";
    ImGui::PushFont(small_font());
    draw_text(from_imgui(ImGui::GetCursorScreenPos()), ImGui::GetContentRegionAvail().x, colors::dim_text,
              text);
    ImGui::Dummy({ImGui::GetContentRegionAvail().x, ImGui::GetTextLineHeight()});
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s\n%s", text.c_str(), tooltip);
    ImGui::PopFont();
    scale_legend(legend.measured);
    keep_range(display, legend.measured);
}

void choose_shading(Display& display, Shading shown_shading) {
    constexpr std::array<const char*, 2> labels{"Smooth", "Flat"};
    const std::string smooth =
        with_keys("Shade smoothly, with the exact normals of the blend", {"Smooth shading"});
    const std::string flat = with_keys("Shade each leaf flat, so that its shape is seen", {"Smooth shading"});
    const std::array<const char*, 2> tips{smooth.c_str(), flat.c_str()};
    const float width = std::round(ImGui::GetContentRegionAvail().x * 0.54F);
    const std::size_t shown = shown_shading == Shading::smooth ? 0 : 1;
    const std::size_t chosen = choice("shading", labels, shown, width, tips);
    if (chosen != shown) display.shading = chosen == 0 ? Shading::smooth : Shading::flat;
    ImGui::SameLine();
    choose_material(display);
    check("Occlusion", display.occlusion,
          with_keys("Darken hollows, where less light arrives", {"Ambient occlusion"}));
    check("Ground", display.ground,
          with_keys("Show a ground below the surface, with its soft shadow", {"Ground"}), true);
}

void choose_lines(Display& display) {
    check("Wireframe", display.wireframe, with_keys("Show the edges of the leaves", {"Wireframe"}));
    check("Roots", display.root_edges,
          with_keys("Show the edges of the root complex, which all keys share", {"Root edges"}), true);
    check("Refinement edges", display.refinement_edges,
          with_keys("Show the edge of each leaf that bisection would split next", {"Refinement edges"}));
    check("Vertices", display.vertices, with_keys("Show a dot at each vertex of the leaves", {"Vertices"}));
    check("Normals", display.normals,
          with_keys("Show a line along the normal at each vertex, or at some of very many", {"Normals"}),
          true);
}

void choose_color(Display& display, const Legend& legend, bool& asks_for_unit) {
    coloring_choice(display.coloring, !legend.fields.empty());
    if (display.coloring == Coloring::level) level_legend(legend.levels);
    if (display.coloring == Coloring::origin) origin_legend(legend);
    if (display.coloring == Coloring::common) common_legend(legend);
    if (is_measured(display.coloring)) measured_legend(display, legend);
    if (display.coloring == Coloring::field)
        display = field_panel(display, legend.fields, legend.key_without_field.value_or(""), legend.is_flat,
                              asks_for_unit);
    if (display.coloring == Coloring::field && legend.curves != nullptr)
        field_curves(*legend.curves, legend.time);
}

}  // namespace

DisplayPanelResult display_panel(const Display& shown, const Legend& legend) {
    DisplayPanelResult result{.display = shown};
    Display& display = result.display;
    if (section("Shading", {}, "How the surface is lit, and what it is made of."))
        choose_shading(display, legend.shading);
    section_gap();
    if (section("Lines", {}, "Edges, vertices and normals over the surface.")) choose_lines(display);
    section_gap();
    if (section("Color", {}, "What the colors of the surface mean."))
        choose_color(display, legend, result.asks_for_unit);
    return result;
}

}  // namespace interleaf
