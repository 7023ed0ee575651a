// Tests of the themes: their text is legible wherever it stands (WCAG 2.1, contrast of 4.5 to 1).
#include "ui/widgets/theme.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <doctest/doctest.h>

#include "ui/headless_gui.h"
#include "ui/widgets/gui_state.h"
#include "ui/widgets/style.h"

using namespace interleaf;

namespace {

/// Relative luminance as WCAG 2.1 defines it.
double luminance(ImU32 color) {
    const auto part = [](ImU32 bits) {
        const double value = static_cast<double>(bits & 0xffU) / 255;
        return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
    };
    return 0.2126 * part(color >> IM_COL32_R_SHIFT) + 0.7152 * part(color >> IM_COL32_G_SHIFT) +
           0.0722 * part(color >> IM_COL32_B_SHIFT);
}

double contrast(ImU32 a, ImU32 b) {
    const double first = luminance(a);
    const double second = luminance(b);
    return (std::max(first, second) + 0.05) / (std::min(first, second) + 0.05);
}

constexpr double legible = 4.5;

}  // namespace

TEST_CASE("the contrast of the test is that of the standard") {
    CHECK(contrast(colors::white, IM_COL32(0, 0, 0, 255)) == doctest::Approx(21));
    CHECK(contrast(IM_COL32(118, 118, 118, 255), colors::white) == doctest::Approx(4.54).epsilon(0.001));
}

TEST_CASE("text has enough contrast in both themes, on everything that it stands on") {
    for (const Theme theme : {Theme::dark, Theme::light}) {
        CAPTURE(std::string(name_of(theme)));
        const Palette& palette = palette_of(theme);
        for (const ImU32 ground : {palette.window, palette.popup, palette.menu_bar, palette.well,
                                   palette.frame, palette.frame_hovered, palette.chosen,
                                   palette.chosen_hovered, palette.selected, palette.selected_hovered}) {
            CAPTURE(ground);
            CHECK(contrast(palette.text, ground) >= legible);
        }
        for (const ImU32 ground :
             {palette.window, palette.popup, palette.menu_bar, palette.well, palette.frame, palette.rim}) {
            CAPTURE(ground);
            CHECK(contrast(palette.dim_text, ground) >= legible);
            CHECK(contrast(palette.notice, ground) >= legible);
        }
        CHECK(contrast(palette.accent, palette.window) >= legible);
        CHECK(contrast(palette.accent, palette.popup) >= legible);
    }
}

TEST_CASE("a chosen button differs from one that is not, under the pointer, too") {
    for (const Theme theme : {Theme::dark, Theme::light}) {
        const Palette& palette = palette_of(theme);
        CHECK(palette.chosen != palette.frame);
        CHECK(contrast(palette.chosen_hovered, palette.frame_hovered) > 1.2);
    }
}

TEST_CASE("colors are those of the present theme") {
    HeadlessGui gui({100, 100});
    const ImU32 dark = colors::text;
    gui_state()->theme = Theme::light;
    const ImU32 light = colors::text;
    CHECK(dark == palette_of(Theme::dark).text);
    CHECK(light == palette_of(Theme::light).text);
    CHECK(theme_named(name_of(Theme::light)) == Theme::light);
    CHECK_FALSE(theme_named("blue"));
}
