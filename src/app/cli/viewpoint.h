// A direction of view on a family, independent of the size of the picture.
#pragma once

#include "family/family.h"
#include "render/camera.h"

namespace interleaf {

/// The place of the camera. At zoom 1 the picture shows the box of all keys.
struct Viewpoint {
    float azimuth = 30;    ///< about Y, 0 from +Z, degrees
    float elevation = 20;  ///< above the XZ plane, degrees
    float zoom = 1;        ///< a zoom above 1 is nearer
    bool operator==(const Viewpoint&) const = default;
};

/// \param aspect  width / height of the picture
Camera camera_on(const Family& family, const Viewpoint& viewpoint, float aspect);

}  // namespace interleaf
