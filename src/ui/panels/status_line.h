// The status line: the size of the shown surface, and the time it takes.
#pragma once

#include <cstddef>

#include "ui/widgets/rect.h"

namespace interleaf {

struct StatusFigures {
    std::size_t active_keys;
    std::size_t leaves;  ///< leaves of the union
    std::size_t vertices;
    double rebuild_milliseconds;  ///< duration of the last rebuild of the union
    double frame_milliseconds;
};

void status_line(const Rect& rect, const StatusFigures& figures);

}  // namespace interleaf
