// The status line: the size of the shown surface, and the time it takes.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

#include "ui/widgets/rect.h"

namespace interleaf {

struct StatusFigures {
    std::size_t active_keys;
    std::size_t leaves;                     ///< leaves of the shown surface
    std::optional<std::size_t> max_leaves;  ///< the budget while the detail follows the camera
    std::size_t vertices;
    std::optional<double> measured_part;  ///< of the keys, for their detail, 0 to 1; none for nothing to do
    double rebuild_milliseconds;          ///< duration of the last rebuild of the union
    double frame_milliseconds;
    std::string_view report = {};  ///< what the user has done last, shown first; empty for none
};

void status_line(const Rect& rect, const StatusFigures& figures);

}  // namespace interleaf
