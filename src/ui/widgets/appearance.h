// How the window looks, as far as the user decides: kept in the settings.
#pragma once

#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace interleaf {

enum class Theme { dark, light };

/// "dark" or "light".
constexpr std::string_view name_of(Theme theme) {
    return theme == Theme::dark ? "dark" : "light";
}

constexpr std::optional<Theme> theme_named(std::string_view name) {
    for (const Theme theme : {Theme::dark, Theme::light})
        if (name == name_of(theme)) return theme;
    return std::nullopt;
}

/// Sizes of the panels that the user has dragged, in screen coordinates at scale 1; none for the usual size.
struct PanelSizes {
    std::optional<float> left{};      ///< width
    std::optional<float> right{};     ///< width
    std::optional<float> timeline{};  ///< height
    bool operator==(const PanelSizes&) const = default;
};

/// Limits of the size of the text, relative to that of the display, and one step of it.
inline constexpr float min_text_scale = 0.75F;
inline constexpr float max_text_scale = 2;
inline constexpr float text_scale_step = 0.125F;

struct Appearance {
    Theme theme = Theme::dark;
    float text_scale = 1;  ///< size of text and controls, from min_text_scale to max_text_scale
    PanelSizes panels{};
    std::vector<std::string> closed_sections{};  ///< titles of the closed parts of panels
    bool operator==(const Appearance&) const = default;
};

}  // namespace interleaf
