#include "app/document/viewpoint.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/core.h>

#include "app/document/expected_text.h"
#include "app/document/family_extent.h"
#include "io/text/joined_text.h"
#include "text/parsed_number.h"

namespace interleaf {
namespace {

constexpr double max_coordinate = 1e30;

/// A number from \p min to \p max.
float number_within(std::string_view text, double min, double max, const char* what) {
    const std::optional<double> number = parsed_number<double>(text);
    if (!number || !(*number >= min && *number <= max)) fail_expecting(what, text);
    return static_cast<float>(*number);
}

glm::vec3 center_in(std::string_view text) {
    constexpr const char* what = "center=X:Y:Z";
    const std::vector<std::string_view> coordinates = split_at(text, ':');
    if (coordinates.size() != 3) fail_expecting(what, text);
    glm::vec3 center;
    for (int i = 0; i < 3; ++i)
        center[i] =
            number_within(coordinates[static_cast<std::size_t>(i)], -max_coordinate, max_coordinate, what);
    return center;
}

UpAxis up_in(std::string_view text) {
    const std::optional<UpAxis> up = up_axis_named(text);
    if (!up) fail_expecting("up=X, up=Y or up=Z", text);
    return *up;
}

/// Takes \p part, "NAME=VALUE" or the name of a projection.
void take_named(std::string_view part, Viewpoint& viewpoint) {
    const std::size_t equals = part.find('=');
    const std::string_view name = part.substr(0, equals);
    const std::string_view value = equals < part.size() ? part.substr(equals + 1) : std::string_view();
    if (name == "roll")
        viewpoint.direction.roll = number_within(value, -360, 360, "a roll from -360 to 360");
    else if (name == "center")
        viewpoint.center = center_in(value);
    else if (name == "distance")
        viewpoint.distance = number_within(value, 1e-30, max_coordinate, "a distance above 0");
    else if (name == "up")
        viewpoint.up = up_in(value);
    else if (part == "orthographic")
        viewpoint.projection = Projection::orthographic;
    else if (part == "perspective")
        viewpoint.projection = Projection::perspective;
    else
        fail_expecting(viewpoint_form, part);
}

}  // namespace

Viewpoint parse_viewpoint(std::string_view text) {
    const std::vector<std::string_view> parts = split_at(text, ',');
    if (parts.size() < 2) fail_expecting(viewpoint_form, text);
    Viewpoint viewpoint;
    viewpoint.direction.azimuth = number_within(parts[0], -360, 360, "an azimuth from -360 to 360");
    viewpoint.direction.elevation = number_within(parts[1], -90, 90, "an elevation from -90 to 90");
    for (std::size_t i = 2; i < parts.size(); ++i) {
        if (i == 2 && parsed_number<double>(parts[i]))
            viewpoint.zoom = number_within(parts[i], 0.01, 100, "a zoom from 0.01 to 100");
        else
            take_named(parts[i], viewpoint);
    }
    return viewpoint;
}

std::string text_of(const Viewpoint& viewpoint) {
    const auto& [azimuth, elevation, roll] = viewpoint.direction;
    std::string text = fmt::format("{},{}", azimuth, elevation);
    if (viewpoint.zoom != 1) text += fmt::format(",{}", viewpoint.zoom);
    if (roll != 0) text += fmt::format(",roll={}", roll);
    if (const auto& center = viewpoint.center)
        text += fmt::format(",center={}:{}:{}", center->x, center->y, center->z);
    if (viewpoint.distance) text += fmt::format(",distance={}", *viewpoint.distance);
    if (viewpoint.projection == Projection::orthographic) text += ",orthographic";
    if (viewpoint.up != UpAxis::y) text += fmt::format(",up={}", name_of(viewpoint.up));
    return text;
}

Viewpoint viewpoint_of(const Camera& camera) {
    return {.direction = camera.direction(),
            .center = camera.target(),
            .distance = camera.distance(),
            .projection = camera.projection(),
            .up = camera.up()};
}

Camera camera_at(const Extent& scene, const Viewpoint& viewpoint, float aspect) {
    Camera camera;
    camera.set_projection(viewpoint.projection);
    camera.set_up(viewpoint.up);
    camera.look_from(viewpoint.direction);
    camera.view_all(scene, aspect);
    camera.look_at(viewpoint.center.value_or(camera.target()),
                   viewpoint.distance.value_or(camera.distance() / viewpoint.zoom));
    return camera;
}

Camera camera_on(const Family& family, const Viewpoint& viewpoint, float aspect) {
    return camera_at(extent(family), viewpoint, aspect);
}

}  // namespace interleaf
