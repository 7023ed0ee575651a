// `interleaf render`: draws a picture of a morph without a display.
#pragma once

#include "app/cli/morph_selection.h"
#include "app/cli/output.h"
#include "render/display.h"

namespace interleaf {

struct PictureSize {
    int width = 1280;  ///< pixels
    int height = 720;
};

/// The place of the camera. At zoom 1 the picture shows the box of all keys.
struct Viewpoint {
    float azimuth = 30;    ///< about Y, 0 from +Z, degrees
    float elevation = 20;  ///< above the XZ plane, degrees
    float zoom = 1;        ///< a zoom above 1 is nearer
};

struct RenderOptions {
    MorphSelection morph;
    Output output;
    PictureSize size;
    Viewpoint viewpoint;
    Display display;
};

/// \throw InputError, UsageError, MachineError
void run_render(const RenderOptions& options);

}  // namespace interleaf
