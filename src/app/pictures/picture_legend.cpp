#include "app/pictures/picture_legend.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "text/value_text.h"

#include "app/document/shown_field.h"
#include "app/pictures/pixel_canvas.h"
#include "ui/widgets/scale_ticks.h"

namespace interleaf {
namespace {

constexpr glm::vec4 box_color(0.078F, 0.086F, 0.106F, 0.86F);
constexpr glm::vec4 ink_color(0.9F, 0.92F, 0.94F, 1);

/// A number beside the bar.
struct LegendNumber {
    float part;  ///< of the bar, 0 to 1 from below
    std::string text;
};

/// The numbers beside the bar: its ends, and ticks between them that are not too near to the ends.
std::vector<LegendNumber> numbers_of(const ColorScale& scale) {
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

/// The color at \p part of the bar.
glm::vec4 bar_color(const ColorScale& scale, float part) {
    const ValueRange& range = scale.range;
    const float value = scale.uses_logarithm() ? range.min * std::pow(range.max / range.min, part)
                                               : std::lerp(range.min, range.max, part);
    return {scale.color(value), 1};
}

/// \p title, cut to \p width with an ellipsis.
std::string fitted_title(std::string title, float size, float width) {
    if (PixelCanvas::text_width(size, title) <= width) return title;
    while (!title.empty() && PixelCanvas::text_width(size, title + "…") > width) {
        while (title.size() > 1 && (static_cast<unsigned char>(title.back()) & 0xc0U) == 0x80)
            title.pop_back();
        title.pop_back();
    }
    return title + "…";
}

/// The measures of a legend, in pixels.
struct LegendLayout {
    float size;    ///< height of a line of text
    float inset;   ///< from the border of the box to what is in it
    float margin;  ///< from the side of the picture to the box
    float tick;    ///< length of a tick
    glm::vec2 bar;
    glm::vec2 box;
    std::string title;
    std::vector<LegendNumber> numbers;
};

/// None if the picture has no room.
std::optional<LegendLayout> layout_of(int width, int height, const PictureLegend& legend) {
    const auto shorter = static_cast<float>(std::min(width, height));
    LegendLayout layout{};
    const float size = layout.size = std::max(11.0F, std::round(shorter / 40));
    layout.inset = std::round(0.8F * size);
    layout.margin = std::round(size);
    layout.tick = std::round(0.35F * size);
    layout.bar = {std::round(0.9F * size),
                  std::round(std::min(15 * size, static_cast<float>(height) - 2 * layout.margin - 5 * size))};
    const float longest = static_cast<float>(width) / 2 - 2 * layout.inset - layout.margin;
    if (layout.bar.y < 3 * size || longest < 3 * size) return std::nullopt;
    layout.numbers = numbers_of(legend.scale);
    float numbers_width = 0;
    for (const LegendNumber& number : layout.numbers)
        numbers_width = std::max(numbers_width, PixelCanvas::text_width(size, number.text));
    layout.title = fitted_title(legend.title, size, longest);
    const float beside_bar = layout.bar.x + 2 * layout.tick + numbers_width;
    if (beside_bar > longest) return std::nullopt;
    const glm::vec2 inner(std::ceil(std::max(beside_bar, PixelCanvas::text_width(size, layout.title))),
                          size + layout.inset + layout.bar.y + std::round(0.4F * size));
    layout.box = inner + 2 * layout.inset;
    return layout;
}

}  // namespace

std::optional<PictureLegend> picture_legend(const Display& display, std::span<const FamilyField> fields) {
    const FamilyField* const field = shown_field(display, fields);
    if (field == nullptr || field->label.kind != FieldKind::scalar) return std::nullopt;
    return PictureLegend{title_with_unit(field->label.name, field->unit), display.scale};
}

float legend_part(int width, int height, const PictureLegend& legend) {
    const std::optional<LegendLayout> layout = layout_of(width, height, legend);
    return layout ? (layout->box.x + layout->margin) / static_cast<float>(width) : 0;
}

void draw_legend(std::span<std::uint8_t> rgba, int width, int height, const PictureLegend& legend) {
    const std::optional<LegendLayout> layout = layout_of(width, height, legend);
    if (!layout) return;
    const auto& [size, inset, margin, tick, bar, box, title, numbers] = *layout;
    PixelCanvas canvas(rgba, width, height);
    const glm::vec2 corner(static_cast<float>(width) - margin - box.x,
                           std::round((static_cast<float>(height) - box.y) / 2));
    canvas.fill(corner, corner + box, std::round(0.4F * size), box_color);
    canvas.text(corner + inset, size, title, ink_color);
    const glm::vec2 top = corner + glm::vec2(inset, 2 * inset + size);
    for (float row = 0; row < bar.y; ++row)
        canvas.fill({top.x, top.y + row}, {top.x + bar.x, top.y + row + 1}, 0,
                    bar_color(legend.scale, 1 - (row + 0.5F) / bar.y));
    for (const LegendNumber& number : numbers) {
        const float y = top.y + std::round((1 - number.part) * bar.y);
        canvas.line({top.x + bar.x, y}, {top.x + bar.x + tick, y}, 1, ink_color);
        canvas.text({top.x + bar.x + 2 * tick, y - std::round(0.55F * size)}, size, number.text, ink_color);
    }
}

}  // namespace interleaf
