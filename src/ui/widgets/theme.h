// The two themes of the user interface, and their colors. A color of the theme is looked up when it is used, so all
// panels follow when the theme changes.
#pragma once

#include <imgui.h>

#include "ui/widgets/appearance.h"

namespace interleaf {

/// The colors of one theme.
struct Palette {
    ImU32 text{};
    ImU32 dim_text{};
    ImU32 accent{};
    ImU32 notice{};      ///< warnings
    ImU32 ink{};         ///< marks that stand out, such as the playhead
    ImU32 rim{};         ///< around marks
    ImU32 label{};       ///< behind text that lies over a picture
    ImU32 well{};        ///< behind bars and canvases
    ImU32 faint_line{};  ///< grids and frames
    ImU32 hover{};       ///< over what the pointer is at
    ImU32 window{};
    ImU32 popup{};
    ImU32 menu_bar{};
    ImU32 border{};
    ImU32 separator{};
    ImU32 frame{};  ///< buttons and fields
    ImU32 frame_hovered{};
    ImU32 chosen{};  ///< pressed and chosen buttons
    ImU32 chosen_hovered{};
    ImU32 selected{};  ///< rows of lists
    ImU32 selected_hovered{};
    ImU32 scrollbar{};
    ImU32 scrollbar_hovered{};
    ImU32 selected_text{};  ///< behind the selected part of a text field
};

const Palette& palette_of(Theme theme);

/// A color of the present theme (gui_state.h); the dark one where there is none.
class ThemeColor {
  public:
    constexpr explicit ThemeColor(ImU32 Palette::*color) : color_(color) {}
    operator ImU32() const;  // NOLINT(google-explicit-constructor): stands for the color wherever it is used

  private:
    ImU32 Palette::*color_;
};

/// Colors of everything that is drawn by hand.
namespace colors {
inline constexpr ThemeColor text(&Palette::text);
inline constexpr ThemeColor dim_text(&Palette::dim_text);
inline constexpr ThemeColor accent(&Palette::accent);
inline constexpr ThemeColor notice(&Palette::notice);
inline constexpr ThemeColor ink(&Palette::ink);
inline constexpr ThemeColor rim(&Palette::rim);
inline constexpr ThemeColor label(&Palette::label);
inline constexpr ThemeColor well(&Palette::well);
inline constexpr ThemeColor faint_line(&Palette::faint_line);
inline constexpr ThemeColor hover(&Palette::hover);
inline constexpr ThemeColor border(&Palette::border);
inline constexpr ThemeColor chosen(&Palette::chosen);
inline constexpr ThemeColor chosen_hovered(&Palette::chosen_hovered);
inline constexpr ThemeColor frame(&Palette::frame);
// The same in both themes: over pictures and over colors of keys.
inline constexpr ImU32 dark = IM_COL32(12, 13, 16, 255);
inline constexpr ImU32 white = IM_COL32(255, 255, 255, 255);
inline constexpr ImU32 path_line = IM_COL32(255, 255, 255, 215);
inline constexpr ImU32 path_rim = IM_COL32(12, 13, 16, 170);
}  // namespace colors

/// Makes the colors of the present theme those of Dear ImGui's \p style.
void set_colors(ImGuiStyle& style);

}  // namespace interleaf
