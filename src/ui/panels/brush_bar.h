// The tool button of the refine brush in a corner of the surface, and beside it the settings of the brush while
// it is in use.
#pragma once

#include <optional>

#include <glm/vec2.hpp>

#include "ui/panels/view_area.h"
#include "ui/widgets/rect.h"

namespace interleaf {

/// The settings of the brush.
struct BrushSettings {
    float radius = 0;  ///< as a part of the diagonal of the key's box
    int refined_level = 0;
    int coarsened_level = 0;
    bool operator==(const BrushSettings&) const = default;
};

struct BrushShown {
    bool is_on = false;
    const char* hint = "";         ///< what the user has to do before the brush works; "" if it does
    bool is_over_surface = false;  ///< the pointer, in the last frame
    bool reads_keys = false;       ///< [ and ] change the brush
    BrushSettings settings;
    float min_radius = 0;
    float max_radius = 1;
    int deepest_level = 0;
};

/// A stroke that the mouse holds.
struct BrushHold {
    glm::vec2 pointer;  ///< in the last frame, window coordinates
    bool coarsens;      ///< Shift or Alt was held when the stroke began
};

struct BrushResult {
    bool toggled = false;                   ///< the tool button was clicked
    std::optional<BrushSettings> settings;  ///< the new settings, if they changed
    bool begins = false;                    ///< a stroke
    std::optional<BrushHold> hold;          ///< the stroke that goes on; none if none does
    glm::vec2 from{0};                      ///< where the pointer was before this frame, during a stroke
};

/// Shows the button and the settings over the upper left corner of the area \p view, and reads the mouse for the
/// brush. Takes what the brush uses away from \p input: a left drag that begins on the surface, unless Ctrl is held,
/// and the wheel with Shift, Ctrl or Alt.
/// \param input  of view_area() in this frame
/// \param held   the stroke that the mouse held in the last frame
BrushResult brush_bar(const Rect& view, const BrushShown& shown, const std::optional<BrushHold>& held,
                      ViewInput& input);

/// Draws the circle of the brush over the surface, within \p view.
/// \param is_active  a stroke goes on
void draw_brush_circle(const Rect& view, glm::vec2 center, float radius, bool is_active);

}  // namespace interleaf
