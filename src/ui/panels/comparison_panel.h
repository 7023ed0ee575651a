// The panel below a fitted key and its mesh while they are compared: which pair is shown, how close they are,
// and the legend of the colors.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "render/color_map.h"
#include "ui/widgets/rect.h"

namespace interleaf {

struct ComparisonShown {
    std::vector<std::string> names;  ///< the keys that can be compared
    std::size_t chosen = 0;
    double hausdorff = 0;         ///< percent of the box diagonal
    double root_mean_square = 0;  ///< percent of the box diagonal
    double min_angle = 0;         ///< degrees
    std::size_t flipped_leaves = 0;
    bool has_colors = true;  ///< colors show the distances
    ColorScale scale;        ///< scale of these colors, percent of the box diagonal
};

struct ComparisonResult {
    std::size_t chosen;
    bool has_colors;
    bool is_over = false;  ///< go back to the document
};

/// Height of the panel in a window of \p width.
float comparison_panel_height(float width);

/// Shows the panel. If \p takes_keyboard is set, Left and Right choose another pair.
ComparisonResult comparison_panel(const Rect& rect, const ComparisonShown& shown, bool takes_keyboard);

}  // namespace interleaf
