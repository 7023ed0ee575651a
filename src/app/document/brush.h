// The refine brush: its size and its levels, and whether it is in use. The strokes are in
// app/brushing/brush_stroke.h.
#pragma once

#include <string>

namespace interleaf {

struct Brush {
    bool is_on = false;
    float radius = 0.04F;          ///< as a part of the diagonal of the selected key's box
    int refined_level = 12;        ///< leaves under the brush get at least this level
    int coarsened_level = 8;       ///< with Shift or Alt, at most this level
    bool is_stroking = false;      ///< the mouse holds a stroke
    bool wants_to_cancel = false;  ///< the present stroke
    std::string report;            ///< what the last stroke did; empty for none
};

inline constexpr float min_brush_radius = 0.0005F;
inline constexpr float max_brush_radius = 0.5F;

/// Deeper levels leave no room between the coordinates of vertices.
inline constexpr int max_brush_level = 40;

}  // namespace interleaf
