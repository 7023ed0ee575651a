#include "app/pictures/pixel_canvas.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "text/characters.h"

#define STB_TRUETYPE_IMPLEMENTATION
#define STBTT_STATIC
#include <stb_truetype.h>

#include "ui/widgets/typeface.h"

namespace interleaf {
namespace {

const stbtt_fontinfo& canvas_font() {
    static const stbtt_fontinfo font = [] {
        stbtt_fontinfo read{};
        stbtt_InitFont(&read, typeface().data(), 0);
        return read;
    }();
    return font;
}

/// The glyphs of \p utf8 one after the other, with the place of their origins along the line in units of the font.
template <typename Take>
int for_glyphs(std::string_view utf8, const Take& take) {
    int at = 0;
    int before = 0;
    while (!utf8.empty()) {
        const Character character = first_character(utf8).value_or(Character{U'?', 1});
        const int glyph = stbtt_FindGlyphIndex(&canvas_font(), static_cast<int>(character.code));
        if (before != 0) at += stbtt_GetGlyphKernAdvance(&canvas_font(), before, glyph);
        take(glyph, at);
        int advance = 0;
        stbtt_GetGlyphHMetrics(&canvas_font(), glyph, &advance, nullptr);
        at += advance;
        before = glyph;
        utf8.remove_prefix(character.size);
    }
    return at;
}

float distance_to_segment(glm::vec2 p, glm::vec2 from, glm::vec2 to) {
    const glm::vec2 along = to - from;
    const float squared = glm::dot(along, along);
    const float part = squared > 0 ? glm::clamp(glm::dot(p - from, along) / squared, 0.0F, 1.0F) : 0;
    return glm::distance(p, from + part * along);
}

}  // namespace

void PixelCanvas::blend(int x, int y, const glm::vec4& color, float coverage) {
    if (x < 0 || y < 0 || x >= width_ || y >= height_) return;
    std::uint8_t* const pixel =
        rgba_.data() +
        4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x));
    const float part = color.a * coverage;
    const float below = static_cast<float>(pixel[3]) / 255;
    const float sum = part + below * (1 - part);
    if (!(sum > 0)) return;
    for (int c = 0; c < 3; ++c) {
        const float mixed = (color[c] * part + static_cast<float>(pixel[c]) / 255 * below * (1 - part)) / sum;
        pixel[c] = static_cast<std::uint8_t>(std::lround(255 * glm::clamp(mixed, 0.0F, 1.0F)));
    }
    pixel[3] = static_cast<std::uint8_t>(std::lround(255 * sum));
}

/// Blends \p color into the pixels from \p low to \p high, with the coverage of each pixel's center.
template <typename Coverage>
void PixelCanvas::cover(glm::vec2 low, glm::vec2 high, const glm::vec4& color, const Coverage& coverage) {
    const glm::ivec2 from(glm::max(glm::floor(low) - 1.0F, glm::vec2(0)));
    const glm::ivec2 to(glm::min(glm::ceil(high) + 1.0F, glm::vec2(width_, height_)));
    for (int y = from.y; y < to.y; ++y)
        for (int x = from.x; x < to.x; ++x) {
            const float part = glm::clamp(coverage(glm::vec2(x, y) + 0.5F), 0.0F, 1.0F);
            if (part > 0) blend(x, y, color, part);
        }
}

void PixelCanvas::fill(glm::vec2 low, glm::vec2 high, float radius, const glm::vec4& color) {
    const glm::vec2 center = 0.5F * (low + high);
    const glm::vec2 inner = 0.5F * (high - low) - radius;
    cover(low, high, color, [&](glm::vec2 p) {
        const glm::vec2 beyond = glm::abs(p - center) - inner;
        const float outside = glm::length(glm::max(beyond, glm::vec2(0)));
        return radius - outside - std::min(std::max(beyond.x, beyond.y), 0.0F) + 0.5F;
    });
}

void PixelCanvas::line(glm::vec2 from, glm::vec2 to, float width, const glm::vec4& color) {
    cover(glm::min(from, to) - width, glm::max(from, to) + width, color,
          [&](glm::vec2 p) { return width / 2 - distance_to_segment(p, from, to) + 0.5F; });
}

void PixelCanvas::triangle(glm::vec2 a, glm::vec2 b, glm::vec2 c, const glm::vec4& color) {
    const auto cross = [](glm::vec2 u, glm::vec2 v) { return u.x * v.y - u.y * v.x; };
    if (cross(b - a, c - a) < 0) std::swap(b, c);
    const auto inside = [&](glm::vec2 p, glm::vec2 from, glm::vec2 to) {
        return cross(to - from, p - from) / std::max(glm::distance(from, to), 1e-6F);
    };
    cover(glm::min(a, glm::min(b, c)), glm::max(a, glm::max(b, c)), color, [&](glm::vec2 p) {
        return std::min({inside(p, a, b), inside(p, b, c), inside(p, c, a)}) + 0.5F;
    });
}

void PixelCanvas::text(glm::vec2 corner, float size, std::string_view utf8, const glm::vec4& color) {
    const float scale = stbtt_ScaleForPixelHeight(&canvas_font(), size);
    int ascent = 0;
    stbtt_GetFontVMetrics(&canvas_font(), &ascent, nullptr, nullptr);
    const float baseline = std::round(corner.y + static_cast<float>(ascent) * scale);
    for_glyphs(utf8, [&](int glyph, int at) {
        const float x = corner.x + static_cast<float>(at) * scale;
        const float column = std::floor(x);
        int left = 0;
        int top = 0;
        int right = 0;
        int bottom = 0;
        stbtt_GetGlyphBitmapBoxSubpixel(&canvas_font(), glyph, scale, scale, x - column, 0, &left, &top,
                                        &right, &bottom);
        const int width = right - left;
        const int height = bottom - top;
        if (width <= 0 || height <= 0) return;
        std::vector<std::uint8_t> coverage(static_cast<std::size_t>(width) *
                                           static_cast<std::size_t>(height));
        stbtt_MakeGlyphBitmapSubpixel(&canvas_font(), coverage.data(), width, height, width, scale, scale,
                                      x - column, 0, glyph);
        for (int row = 0; row < height; ++row)
            for (int n = 0; n < width; ++n)
                blend(static_cast<int>(column) + left + n, static_cast<int>(baseline) + top + row, color,
                      static_cast<float>(
                          coverage[static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
                                   static_cast<std::size_t>(n)]) /
                          255);
    });
}

float PixelCanvas::text_width(float size, std::string_view utf8) {
    const int units = for_glyphs(utf8, [](int, int) {});
    return static_cast<float>(units) * stbtt_ScaleForPixelHeight(&canvas_font(), size);
}

}  // namespace interleaf
