#include "app/cli/viewpoint.h"

#include "app/document/family_extent.h"

namespace interleaf {

Camera camera_on(const Family& family, const Viewpoint& viewpoint, float aspect) {
    Camera camera;
    camera.look_from(viewpoint.azimuth, viewpoint.elevation);
    camera.view_all(extent(family), aspect);
    camera.zoom(viewpoint.zoom, {0, 0}, aspect);
    return camera;
}

}  // namespace interleaf
