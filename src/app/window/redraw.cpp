#include "app/window/redraw.h"

#include <algorithm>

namespace interleaf {

void Redraw::settle() {
    frames_ = settling_frames;
}

void Redraw::follow(const FrameRest& rest) {
    if (rest.has_input || rest.has_changed || rest.moves) settle();
    if (rest.is_coarse || rest.lacks_portraits) frames_ = std::max(frames_, 1);
}

}  // namespace interleaf
