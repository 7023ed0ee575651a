// A film of a family: what each of its frames shows. Frame N is a function of N alone, so the frames can be
// drawn in any order, and by several machines.
#pragma once

#include <cstddef>
#include <optional>

#include "family/family.h"
#include "family/family_time.h"
#include "family/frame_times.h"
#include "render/camera.h"

namespace interleaf {

struct Film {
    FrameTimes frames;
    std::optional<TimeSource> source;  ///< what drives the blend; if none, all frames show the blend `still`
    Weights still;
    Camera camera;         ///< of frame 0
    float turn = 0;        ///< how far the camera turns about the vertical axis in the whole film, degrees
    bool is_loop = false;  ///< whether frame 0 follows the last frame again
};

Weights weights_of_frame(const Film& film, const Family& family, std::size_t number);

/// The camera turns evenly. In a loop the whole turn is done when frame 0 comes again, otherwise at the last
/// frame.
Camera camera_of_frame(const Film& film, std::size_t number);

}  // namespace interleaf
