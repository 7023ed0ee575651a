#include "app/pictures/picture_legend.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

#include <fmt/core.h>

#include "app/document/shown_field.h"
#include "app/pictures/pixel_canvas.h"
#include "text/value_text.h"
#include "ui/widgets/legend_text.h"
#include "ui/widgets/scale_ticks.h"

namespace interleaf {
namespace {

/// The ground of the legend, and what is written on it.
struct LegendStyle {
    glm::vec4 box;
    glm::vec4 ink;
};

constexpr LegendStyle dark_style{{0.078F, 0.086F, 0.106F, 0.86F}, {0.9F, 0.92F, 0.94F, 1}};
constexpr LegendStyle light_style{{0.96F, 0.965F, 0.975F, 0.86F}, {0.12F, 0.14F, 0.18F, 1}};

/// A number beside the bar.
struct LegendNumber {
    float part;  ///< of the bar, 0 to 1 from below
    std::string text;
};

/// The ends of the scale, and ticks between them that are not too near to the ends.
std::vector<LegendNumber> numbers_of(const ColorScale& scale, float /*max_count*/) {
    const double low = double{scale.range.min} + scale.offset;
    const double high = double{scale.range.max} + scale.offset;
    if (!(high > low)) return {{0.5F, value_text(low, 0)}};
    std::vector<LegendNumber> numbers = {{0, value_text(low, high - low)}, {1, value_text(high, high - low)}};
    constexpr std::size_t max_ticks = 5;
    constexpr float least_distance = 0.09F;
    const auto ticks = scale.uses_logarithm() ? logarithmic_ticks : scale_ticks;
    for (const double tick : ticks(low, high, max_ticks)) {
        const double part = scale.uses_logarithm() ? std::log(tick / low) / std::log(high / low)
                                                   : (tick - low) / (high - low);
        const float at = static_cast<float>(part);
        if (at > least_distance && at < 1 - least_distance)
            numbers.push_back({at, value_text(tick, high - low)});
    }
    return numbers;
}

unsigned level_count(const LevelRange& levels) {
    return levels.max - levels.min + 1;
}

/// Every level, or those whose number has a common factor, so that at most \p max_count numbers stand above each other.
std::vector<LegendNumber> numbers_of(const LevelRange& levels, float max_count) {
    const auto count = static_cast<float>(level_count(levels));
    const auto every = static_cast<unsigned>(std::max(std::ceil(count / max_count), 1.0F));
    std::vector<LegendNumber> numbers;
    for (unsigned level = levels.min; level <= levels.max; ++level)
        if (level % every == 0)
            numbers.push_back(
                {(static_cast<float>(level - levels.min) + 0.5F) / count, fmt::format("{}", level)});
    return numbers;
}

/// The color at \p part of the bar.
glm::vec3 bar_color(const ColorScale& scale, float part) {
    const ValueRange& range = scale.range;
    return scale.color(scale.uses_logarithm() ? range.min * std::pow(range.max / range.min, part)
                                              : std::lerp(range.min, range.max, part));
}

glm::vec3 bar_color(const LevelRange& levels, float part) {
    const unsigned count = level_count(levels);
    const auto step = static_cast<unsigned>(part * static_cast<float>(count));
    return level_color(levels.min + std::min(step, count - 1), levels);
}

/// \p text, cut to \p width with an ellipsis.
std::string fitted_text(std::string text, float size, float width) {
    if (PixelCanvas::text_width(size, text) <= width) return text;
    while (!text.empty() && PixelCanvas::text_width(size, text + "…") > width) {
        while (text.size() > 1 && (static_cast<unsigned char>(text.back()) & 0xc0U) == 0x80) text.pop_back();
        text.pop_back();
    }
    return text + "…";
}

/// The measures of a legend, in pixels.
struct LegendLayout {
    float size;          ///< height of a line of text
    float inset;         ///< from the border of the box to what is in it
    float margin;        ///< from the side of the picture to the box
    float tick;          ///< length of a tick
    float swatch;        ///< width of the bar, and side of the colored squares of a list
    float row;           ///< from a row of a list to the next
    glm::vec2 longest;   ///< that what is below the title may be
    glm::vec2 contents;  ///< size of what is below the title
    glm::vec2 box;
    std::string title;
};

/// The size of a bar and its numbers.
template <typename Colors>
glm::vec2 contents_size(const Colors& colors, const LegendLayout& layout) {
    float widest = PixelCanvas::text_width(layout.size, "00");  // levels of the union may get a second digit
    for (const LegendNumber& number : numbers_of(colors, layout.longest.y / layout.row))
        widest = std::max(widest, PixelCanvas::text_width(layout.size, number.text));
    return {layout.swatch + 2 * layout.tick + widest, layout.longest.y};
}

/// Lists are equally wide, whatever stands in them.
glm::vec2 contents_size(const std::vector<LegendEntry>& list, const LegendLayout& layout) {
    const float rows = std::min(static_cast<float>(list.size()), std::floor(layout.longest.y / layout.row));
    return {std::min(12 * layout.size, layout.longest.x), rows * layout.row};
}

/// None if the picture has no room.
std::optional<LegendLayout> layout_of(int width, int height, const PictureLegend& legend) {
    const auto shorter = static_cast<float>(std::min(width, height));
    LegendLayout layout{};
    const float size = layout.size = std::max(11.0F, std::round(shorter / 40));
    layout.inset = std::round(0.8F * size);
    layout.margin = std::round(size);
    layout.tick = std::round(0.35F * size);
    layout.swatch = std::round(0.9F * size);
    layout.row = std::round(1.4F * size);
    layout.longest = {
        static_cast<float>(width) / 2 - 2 * layout.inset - layout.margin,
        std::round(std::min(15 * size, static_cast<float>(height) - 2 * layout.margin - 5 * size))};
    if (layout.longest.y < 3 * size || layout.longest.x < 3 * size) return std::nullopt;
    layout.contents =
        std::visit([&](const auto& colors) { return contents_size(colors, layout); }, legend.colors);
    if (layout.contents.x > layout.longest.x) return std::nullopt;
    layout.title = fitted_text(legend.title, size, layout.longest.x);
    const float inner = std::max(layout.contents.x, PixelCanvas::text_width(size, layout.title));
    layout.box =
        glm::vec2(std::ceil(inner), size + layout.inset + layout.contents.y + std::round(0.4F * size)) +
        2 * layout.inset;
    return layout;
}

/// Draws a bar of the colors with its numbers.
template <typename Colors>
void draw_contents(PixelCanvas& canvas, glm::vec2 top, const LegendLayout& layout, const Colors& colors,
                   const glm::vec4& ink) {
    const float height = layout.contents.y;
    const float side = top.x + layout.swatch;
    for (float row = 0; row < height; ++row)
        canvas.fill({top.x, top.y + row}, {side, top.y + row + 1}, 0,
                    {bar_color(colors, 1 - (row + 0.5F) / height), 1});
    for (const LegendNumber& number : numbers_of(colors, height / layout.row)) {
        const float y = top.y + std::round((1 - number.part) * height);
        canvas.line({side, y}, {side + layout.tick, y}, 1, ink);
        canvas.text({side + 2 * layout.tick, y - std::round(0.55F * layout.size)}, layout.size, number.text,
                    ink);
    }
}

/// Draws a row per entry; where there are too many, the last row says how many more there are.
void draw_contents(PixelCanvas& canvas, glm::vec2 top, const LegendLayout& layout,
                   const std::vector<LegendEntry>& list, const glm::vec4& ink) {
    const auto rows = static_cast<std::size_t>(std::round(layout.contents.y / layout.row));
    const std::size_t shown = rows < list.size() ? rows - 1 : rows;
    const float indent = layout.swatch + 2 * layout.tick;
    const auto write = [&](float left, const std::string& text) {
        canvas.text({top.x + left, top.y}, layout.size,
                    fitted_text(text, layout.size, layout.contents.x - left), ink);
        top.y += layout.row;
    };
    for (const LegendEntry& entry : std::span(list).first(shown)) {
        canvas.fill(top, top + layout.swatch, std::round(0.2F * layout.size), {entry.color, 1});
        write(indent, entry.text);
    }
    if (shown < list.size()) write(0, fmt::format("and {} others", list.size() - shown));
}

std::vector<LegendEntry> origin_entries(std::span<const std::string> names, std::span<const std::size_t> keys,
                                        const UnionMesh& mesh) {
    std::vector<std::string> active;
    active.reserve(keys.size());
    for (const std::size_t key : keys) active.push_back(names[key]);
    std::vector<LegendEntry> entries;
    for (const KeySet origin : origins_of(mesh))
        entries.push_back({origin_color(origin, keys), origin_name(origin, active)});
    return entries;
}

std::vector<LegendEntry> common_entries(std::size_t key_count, const UnionMesh& mesh) {
    std::vector<LegendEntry> entries;
    for (const ShareMeaning& meaning : share_meanings(origins_of(mesh), key_count))
        entries.push_back({common_color(meaning.share), meaning.text});
    return entries;
}

}  // namespace

bool has_picture_legend(const Display& display, std::span<const FamilyField> fields) {
    if (display.coloring == Coloring::plain || display.coloring == Coloring::checker) return false;
    if (display.coloring != Coloring::field) return true;
    const FamilyField* const field = shown_field(display, fields);
    return field != nullptr && field->label.kind == FieldKind::scalar;
}

PictureLegend picture_legend(const Display& display, std::span<const FamilyField> fields,
                             std::span<const std::string> names, std::span<const std::size_t> keys,
                             const UnionMesh& mesh) {
    assert(has_picture_legend(display, fields));
    PictureLegend legend{.title = {}, .colors = display.scale, .is_light = display.light_background};
    switch (display.coloring) {
        case Coloring::level:
            legend.title = "Level";
            legend.colors = level_range(mesh);
            break;
        case Coloring::origin:
            legend.title = "Bisected this far in";
            legend.colors = origin_entries(names, keys, mesh);
            break;
        case Coloring::common:
            legend.title = "Bisected this far";
            legend.colors = common_entries(keys.size(), mesh);
            break;
        case Coloring::angle:
            legend.title = "Angle (degrees)";
            break;
        case Coloring::curvature:
            legend.title = "Mean curvature";
            break;
        case Coloring::moved:
            legend.title = "Distance moved";
            break;
        default: {
            const FamilyField& field = *shown_field(display, fields);
            legend.title = title_with_unit(field.label.name, field.unit);
        }
    }
    return legend;
}

float legend_part(int width, int height, const PictureLegend& legend) {
    const std::optional<LegendLayout> layout = layout_of(width, height, legend);
    return layout ? (layout->box.x + layout->margin) / static_cast<float>(width) : 0;
}

void draw_legend(std::span<std::uint8_t> rgba, int width, int height, const PictureLegend& legend) {
    const std::optional<LegendLayout> layout = layout_of(width, height, legend);
    if (!layout) return;
    const auto& [box_color, ink] = legend.is_light ? light_style : dark_style;
    PixelCanvas canvas(rgba, width, height);
    const glm::vec2 corner(static_cast<float>(width) - layout->margin - layout->box.x,
                           std::round((static_cast<float>(height) - layout->box.y) / 2));
    canvas.fill(corner, corner + layout->box, std::round(0.4F * layout->size), box_color);
    canvas.text(corner + layout->inset, layout->size, layout->title, ink);
    const glm::vec2 top = corner + glm::vec2(layout->inset, 2 * layout->inset + layout->size);
    std::visit([&](const auto& colors) { draw_contents(canvas, top, *layout, colors, ink); }, legend.colors);
}

}  // namespace interleaf
