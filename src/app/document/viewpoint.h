// A view of a family, independent of the size of the picture, and its text: the value of --camera, and what the
// window copies and pastes.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include <glm/vec3.hpp>

#include "family/family.h"
#include "hierarchy/measure.h"
#include "render/camera.h"

namespace interleaf {

/// The place of the camera. With neither center nor distance and at zoom 1, the picture shows the box of all keys.
struct Viewpoint {
    Direction direction{30, 20, 0};
    float zoom = 1;  ///< a zoom above 1 is nearer; relative to the view of all keys
    std::optional<glm::vec3>
        center{};  ///< of the picture, in the coordinates of the keys; by default of all keys
    std::optional<float> distance{};  ///< of the eye from the center; replaces the zoom
    Projection projection = Projection::perspective;
    UpAxis up = UpAxis::y;
    bool operator==(const Viewpoint&) const = default;
};

/// What the texts look like, for the help.
inline constexpr const char* viewpoint_form =
    "AZIMUTH,ELEVATION[,ZOOM][,roll=DEGREES][,center=X:Y:Z][,distance=D][,orthographic][,up=Z]";

/// \throw UsageError naming what was expected
Viewpoint parse_viewpoint(std::string_view text);

/// The text that parse_viewpoint() takes for \p viewpoint, with all digits.
std::string text_of(const Viewpoint& viewpoint);

/// The view of \p camera, with center and distance.
Viewpoint viewpoint_of(const Camera& camera);

/// \param scene   of all keys of a family
/// \param aspect  width / height of the picture
Camera camera_at(const Extent& scene, const Viewpoint& viewpoint, float aspect);

/// As camera_at(), on the keys of \p family.
Camera camera_on(const Family& family, const Viewpoint& viewpoint, float aspect);

}  // namespace interleaf
