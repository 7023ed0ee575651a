// A rectangle of the window, in screen coordinates, y down.
#pragma once

namespace interleaf {

struct Rect {
    float x = 0;
    float y = 0;
    float width = 0;
    float height = 0;

    float right() const { return x + width; }
    float bottom() const { return y + height; }
    bool operator==(const Rect&) const = default;
};

}  // namespace interleaf
