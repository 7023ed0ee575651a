// Reads pictures.
#include "render/picture.h"

#include <cstdlib>
#include <string>

#include <doctest/doctest.h>
#include <glad/gl.h>

#include "render/context.h"

namespace interleaf {

glm::vec3 Picture::light(int x, int y) const {
    const std::uint8_t* pixel = &rgba[4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                                           static_cast<std::size_t>(x))];
    return linear_light(glm::vec3(pixel[0], pixel[1], pixel[2]) / 255.0F);
}

Picture take_picture(Renderer& renderer, OffscreenTarget& target, const Camera& camera,
                     std::span<const float> weights, const Display& display) {
    renderer.draw(target, camera, weights, display);
    Picture picture{target.width(), target.height(), target.read_rgba()};
    CHECK(glGetError() == GL_NO_ERROR);
    for (const std::string& message : take_debug_messages()) FAIL_CHECK("OpenGL says: " << message);
    return picture;
}

int count_pixels(const Picture& picture, const std::function<bool(glm::vec3 light)>& holds) {
    int count = 0;
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) count += holds(picture.light(x, y)) ? 1 : 0;
    return count;
}

int count_differences(const Picture& a, const Picture& b, int tolerance) {
    REQUIRE(a.rgba.size() == b.rgba.size());
    int count = 0;
    for (std::size_t pixel = 0; pixel < a.rgba.size(); pixel += 4) {
        bool differs = false;
        for (std::size_t c = pixel; c < pixel + 4; ++c)
            differs |= std::abs(a.rgba[c] - b.rgba[c]) > tolerance;
        count += differs ? 1 : 0;
    }
    return count;
}

double mean_brightness(const Picture& picture) {
    double sum = 0;
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) {
            const glm::vec3 light = picture.light(x, y);
            sum += static_cast<double>(light.r + light.g + light.b);
        }
    return sum / (picture.width * picture.height);
}

glm::vec2 pixel_of(const Camera& camera, const Picture& picture, glm::vec3 point) {
    const glm::vec2 size(picture.width, picture.height);
    const glm::vec4 clip = camera.projection(size.x / size.y) * camera.view() * glm::vec4(point, 1);
    return (glm::vec2(clip.x, -clip.y) / clip.w + 1.0F) / 2.0F * size;
}

bool is_red(glm::vec3 light) {
    return light.r > 0.3F && light.r > 3 * light.g && light.r > 3 * light.b;
}
bool is_white(glm::vec3 light) {
    return light.r > 0.8F && light.g > 0.85F && light.b > 0.9F;
}
bool is_black(glm::vec3 light) {
    return light.r < 0.016F && light.g < 0.018F && light.b < 0.024F;
}

}  // namespace interleaf
