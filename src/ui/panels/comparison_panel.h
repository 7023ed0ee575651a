// What stands below a fitted key and its mesh while they are compared: which pair it is, how near they are,
// and what the colors mean.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "render/color_map.h"
#include "ui/widgets/rect.h"

namespace interleaf {

struct ComparisonShown {
    std::vector<std::string> names;  ///< of the keys that can be compared
    std::size_t chosen = 0;
    double hausdorff = 0;         ///< percent of the box diagonal
    double root_mean_square = 0;  ///< percent of the box diagonal
    double min_angle = 0;         ///< degrees
    std::size_t flipped_leaves = 0;
    bool has_colors = true;  ///< distances as colors, by this scale:
    ColorScale scale;        ///< percent of the box diagonal
};

struct ComparisonResult {
    std::size_t chosen;
    bool has_colors;
    bool is_over = false;  ///< back to the document
};

/// Height of the panel in a window of \p width.
float comparison_panel_height(float width);

/// Left and Right choose another pair, unless \p takes_keyboard is off: then all keys are for something else.
ComparisonResult comparison_panel(const Rect& rect, const ComparisonShown& shown, bool takes_keyboard);

}  // namespace interleaf
