#include "ui/panels/display_panel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <vector>

#include <fmt/core.h>
#include <imgui.h>

#include "ui/panels/field_panel.h"
#include "ui/widgets/choice.h"
#include "ui/widgets/style.h"

namespace interleaf {

namespace {

/// Buttons side by side, as wide as the panel. One of them is chosen.
template <typename Choice, std::size_t count>
void choice(const char* name, Choice& value, const std::pair<const char*, Choice> (&options)[count]) {
    std::array<const char*, count> labels{};
    std::size_t chosen = count;
    for (std::size_t i = 0; i < count; ++i) {
        labels[i] = options[i].first;
        if (options[i].second == value) chosen = i;
    }
    const std::size_t now = interleaf::choice(name, labels, chosen, ImGui::GetContentRegionAvail().x);
    if (now < count) value = options[now].second;
}

/// Shows the colorings in rows of three buttons.
void coloring_choice(Coloring& value, bool has_fields) {
    constexpr std::size_t columns = 3;
    const std::vector<Coloring> all = colorings(has_fields);
    for (std::size_t begin = 0; begin < all.size(); begin += columns) {
        const auto row = std::span(all).subspan(begin, std::min(columns, all.size() - begin));
        std::vector<const char*> labels;
        for (const Coloring coloring : row) labels.push_back(label_of(coloring));
        const auto chosen = static_cast<std::size_t>(std::ranges::find(row, value) - row.begin());
        const float width = ImGui::GetContentRegionAvail().x;
        const std::size_t now = interleaf::choice(labels.front(), labels, chosen, width);
        if (now < row.size()) value = row[now];
    }
}

void level_legend(LevelRange levels) {
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
    heading(fmt::format("level {}", levels.min),
            levels.max > levels.min ? fmt::format("{}", levels.max) : "");
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

void origin_legend(const Legend& legend) {
    ImGui::PushFont(small_font());
    const float width = ImGui::GetContentRegionAvail().x;
    const float swatch = scaled(10);
    const float indent = scaled(18);
    const std::size_t shown = std::min(legend.origins.size(), max_origin_rows);
    for (const KeySet origin : legend.origins.first(shown)) {
        const glm::vec2 corner = from_imgui(ImGui::GetCursorScreenPos());
        const float height = ImGui::GetTextLineHeight();
        const float top = corner.y + std::round((height - swatch) / 2);
        ImGui::GetWindowDrawList()->AddRectFilled({corner.x, top}, {corner.x + swatch, top + swatch},
                                                  to_color(origin_color(origin, legend.active_keys)),
                                                  scaled(2));
        const std::string name = origin_name(origin, legend);
        draw_text({corner.x + indent, corner.y}, width - indent, colors::text, name);
        ImGui::Dummy({width, height});
        if (ImGui::IsItemHovered()) ImGui::SetTooltip("Bisected this far in %s", name.c_str());
    }
    if (shown < legend.origins.size())
        wrapped_text(fmt::format("and {} other sets of keys", legend.origins.size() - shown),
                     colors::dim_text);
    ImGui::PopFont();
}

}  // namespace

DisplayPanelResult display_panel(const Display& shown, const Legend& legend) {
    DisplayPanelResult result{.display = shown};
    Display& display = result.display;
    heading("Shading");
    choice("shading", display.shading, {{"Smooth", Shading::smooth}, {"Flat", Shading::flat}});
    ImGui::Checkbox("Ambient occlusion", &display.occlusion);
    section_gap();
    heading("Lines");
    ImGui::Checkbox("Wireframe", &display.wireframe);
    ImGui::Checkbox("Refinement edges", &display.refinement_edges);
    ImGui::Checkbox("Root edges", &display.root_edges);
    section_gap();
    heading("Color");
    coloring_choice(display.coloring, !legend.fields.empty());
    if (display.coloring == Coloring::level) level_legend(legend.levels);
    if (display.coloring == Coloring::origin) origin_legend(legend);
    if (display.coloring == Coloring::field)
        display = field_panel(display, legend.fields, legend.key_without_field.value_or(""), legend.is_flat,
                              result.asks_for_unit);
    if (display.coloring == Coloring::field && legend.curves != nullptr)
        field_curves(*legend.curves, legend.time);
    return result;
}

}  // namespace interleaf
