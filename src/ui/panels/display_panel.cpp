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
#include "ui/widgets/scale_legend.h"
#include "ui/widgets/section.h"
#include "ui/widgets/short_name.h"
#include "ui/widgets/style.h"
#include "ui/widgets/tooltip.h"

namespace interleaf {

namespace {

/// Shows the colorings in rows.
void coloring_choice(Coloring& value, bool has_fields) {
    constexpr std::size_t in_row = 3;
    const std::vector<Coloring> all = colorings(has_fields);
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
void check(const char* label, bool& value, const char* tip, bool is_second = false) {
    if (is_second) {
        const float left = ImGui::GetStyle().WindowPadding.x;
        const float column = (ImGui::GetContentRegionAvail().x + ImGui::GetStyle().ItemSpacing.x) / 2;
        ImGui::SameLine(left + std::round(column));
    }
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {scaled(2), scaled(2)});
    ImGui::Checkbox(label, &value);
    ImGui::PopStyleVar();
    tooltip(tip);
}

void choose_material(Display& display) {
    ImGui::SetNextItemWidth(-1);
    const bool is_open = ImGui::BeginCombo("##material", label_of(display.material));
    if (!is_open) return tooltip("What a plain surface looks to be made of (Ctrl+M)");
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
    const float swatch = scaled(10);
    const float indent = scaled(18);
    const glm::vec2 corner = from_imgui(ImGui::GetCursorScreenPos());
    const float height = ImGui::GetTextLineHeight();
    const float top = corner.y + std::round((height - swatch) / 2);
    ImGui::GetWindowDrawList()->AddRectFilled({corner.x, top}, {corner.x + swatch, top + swatch},
                                              to_color(color), scaled(2));
    draw_text({corner.x + indent, corner.y}, width - indent, colors::text, text);
    ImGui::Dummy({width, height});
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", tooltip.c_str());
}

/// Many active keys can make thousands of origins.
constexpr std::size_t max_origin_rows = 12;

std::string origin_name(KeySet origin, const Legend& legend) {
    std::string name;
    for (std::size_t i = 0; i < legend.active_names.size(); ++i) {
        if ((origin & key_bit(i)) == 0) continue;
        if (!name.empty()) name += " + ";
        name += legend.active_names[i];
    }
    return name;
}

/// One row of the legend. A long name is cut; the tooltip has all of it.
void origin_row(KeySet origin, const Legend& legend, float width) {
    const float swatch = scaled(10);
    const float indent = scaled(16);
    const glm::vec2 corner = from_imgui(ImGui::GetCursorScreenPos());
    const float height = ImGui::GetTextLineHeight();
    const float top = corner.y + std::round((height - swatch) / 2);
    ImGui::GetWindowDrawList()->AddRectFilled({corner.x, top}, {corner.x + swatch, top + swatch},
                                              to_color(origin_color(origin, legend.active_keys)), scaled(2));
    const std::string name = origin_name(origin, legend);
    draw_text({corner.x + indent, corner.y}, width - indent, colors::text, shortened(name, width - indent));
    ImGui::Dummy({width, height});
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("Leaves that are bisected this far in %s", name.c_str());
}

/// In two columns, where the names have room in them or the column would be long.
void origin_legend(const Legend& legend) {
    constexpr std::size_t long_from = 5;
    ImGui::PushFont(small_font());
    const std::size_t shown = std::min(legend.origins.size(), max_origin_rows);
    const bool has_columns = shown >= long_from;
    const float gap = ImGui::GetStyle().ItemSpacing.x;
    const float room = ImGui::GetContentRegionAvail().x;
    const float width = has_columns ? std::floor((room - gap) / 2) : room;
    for (std::size_t row = 0; row < shown; ++row) {
        if (has_columns && row % 2 == 1) ImGui::SameLine();
        origin_row(legend.origins[row], legend, width);
    }
    if (shown < legend.origins.size())
        wrapped_text(fmt::format("and {} other sets of keys", legend.origins.size() - shown),
                     colors::dim_text);
    ImGui::PopFont();
}

/// The shares that occur on the surface.
void common_legend(const Legend& legend) {
    struct Row {
        Share share;
        const char* text;
        const char* tooltip;
    };
    static constexpr std::array<Row, 3> rows = {{
        {Share::all, "in all active keys",
         "The common complex: the leaves that are nodes in every active key."},
        {Share::some, "in some of them", "Several active keys bisect this far, but not all."},
        {Share::one, "in one of them", "A single active key bisects this far."},
    }};
    ImGui::PushFont(small_font());
    for (const auto& [share, text, tooltip] : rows) {
        const auto has_share = [&](KeySet origin) {
            return share_of(origin, legend.active_keys.size()) == share;
        };
        if (std::ranges::any_of(legend.origins, has_share)) swatch_row(common_color(share), text, tooltip);
    }
    ImGui::PopFont();
}

void measured_legend(Coloring coloring, const Legend& legend) {
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
}

void choose_shading(Display& display) {
    constexpr std::array<const char*, 2> labels{"Smooth", "Flat"};
    constexpr std::array<const char*, 2> tips{"Shade smoothly, with the exact normals of the blend (S)",
                                              "Shade each leaf flat, so that its shape is seen (S)"};
    const float width = std::round(ImGui::GetContentRegionAvail().x * 0.54F);
    const std::size_t chosen = display.shading == Shading::smooth ? 0 : 1;
    display.shading = choice("shading", labels, chosen, width, tips) == 0 ? Shading::smooth : Shading::flat;
    ImGui::SameLine();
    choose_material(display);
    check("Occlusion", display.occlusion, "Darken hollows, where less light arrives (A)");
    check("Ground", display.ground, "Show a ground below the surface, with its soft shadow (Ctrl+G)", true);
}

void choose_lines(Display& display) {
    check("Wireframe", display.wireframe, "Show the edges of the leaves (W)");
    check("Roots", display.root_edges, "Show the edges of the root complex, which all keys share (E)", true);
    check("Refinement edges", display.refinement_edges,
          "Show the edge of each leaf that bisection would split next (R)");
    check("Vertices", display.vertices, "Show a dot at each vertex of the leaves (V)");
    check("Normals", display.normals,
          "Show a line along the normal at each vertex, or at some of very many (N)", true);
}

void choose_color(Display& display, const Legend& legend, bool& asks_for_unit) {
    coloring_choice(display.coloring, !legend.fields.empty());
    if (display.coloring == Coloring::level) level_legend(legend.levels);
    if (display.coloring == Coloring::origin) origin_legend(legend);
    if (display.coloring == Coloring::common) common_legend(legend);
    if (is_measured(display.coloring)) measured_legend(display.coloring, legend);
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
    if (section("Shading", {}, "How the surface is lit, and what it is made of.")) choose_shading(display);
    section_gap();
    if (section("Lines", {}, "Edges, vertices and normals over the surface.")) choose_lines(display);
    section_gap();
    if (section("Color", {}, "What the colors of the surface mean."))
        choose_color(display, legend, result.asks_for_unit);
    return result;
}

}  // namespace interleaf
