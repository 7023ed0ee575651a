// Tests of the picture of a surface: shape, light, colors.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include <doctest/doctest.h>
#include <glad/gl.h>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "render/context.h"
#include "render/picture.h"
#include "render/test_surfaces.h"

using namespace interleaf;

namespace {

constexpr float both[] = {0.5F, 0.5F};

Picture background_of(OffscreenTarget& target) {
    Renderer renderer;
    return take_picture(renderer, target, Camera(), {});
}

std::size_t distinct_colors(const Picture& picture) {
    std::set<std::array<float, 3>> colors;
    count_pixels(picture, [&](glm::vec3 light) { return colors.insert({light.r, light.g, light.b}).second; });
    return colors.size();
}

/// The center of the leaf in the first key.
glm::vec3 middle(const UnionMesh& mesh, std::size_t leaf) {
    const auto& [a, b, c] = mesh.triangles[leaf];
    const auto& positions = mesh.positions.front();
    return (positions[a] + positions[b] + positions[c]) / 3.0F;
}

/// What `filmic` of surface.frag does, and its inverse.
glm::vec3 filmic(glm::vec3 light) {
    const auto bent = [](float x) { return x < 0.45F ? x : 1 - 0.55F * std::exp((0.45F - x) / 0.55F); };
    return {bent(light.r), bent(light.g), bent(light.b)};
}
glm::vec3 light_before_filmic(glm::vec3 light) {
    const auto straight = [](float x) { return x < 0.45F ? x : 0.45F - 0.55F * std::log((1 - x) / 0.55F); };
    return {straight(light.r), straight(light.g), straight(light.b)};
}

/// Checks that \p picture shows each leaf in its color_of() times the incident light. The light is known from
/// \p plain, a picture in the color \p plain_color.
void check_leaf_colors(const UnionMesh& mesh, const Camera& camera, const Picture& plain,
                       glm::vec3 plain_color, const Picture& picture,
                       const std::function<glm::vec3(std::size_t)>& color_of) {
    for (std::size_t leaf = 0; leaf < mesh.leaf_count(); ++leaf) {
        CAPTURE(leaf);
        const glm::ivec2 at(pixel_of(camera, plain, middle(mesh, leaf)));
        const glm::vec3 light = light_before_filmic(plain.light(at.x, at.y)) / linear_light(plain_color);
        const glm::vec3 expected = filmic(light * linear_light(color_of(leaf)));
        CHECK(glm::distance(picture.light(at.x, at.y), expected) < 0.02F);
    }
}

}  // namespace

TEST_CASE("no shown normal points away from the viewer, also along the outline of a coarse surface") {
    const EglContext context;
    const TestSurface sphere = surface_of_shapes({"sphere"}, 80);
    Renderer renderer;
    renderer.upload(sphere.mesh, sphere.form);
    OffscreenTarget target(320, 240, 1);
    Camera camera = camera_on(sphere, target);
    camera.set_projection(Projection::orthographic);
    Display display;
    display.material = Material::normals;
    const Picture picture = take_picture(renderer, target, camera, one, display);
    const Picture background = background_of(target);
    // The material shows half the normal plus one half, to the power of 2.2.
    const float perpendicular = std::pow(0.5F, 2.2F);
    int covered = 0;
    int away = 0;
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) {
            if (picture.light(x, y) == background.light(x, y)) continue;
            ++covered;
            if (picture.light(x, y).b < perpendicular - 0.005F) ++away;
        }
    CHECK(covered > 10'000);
    CHECK(away == 0);
}

TEST_CASE("a sphere covers the disc that geometry predicts, with and without multisampling") {
    const EglContext context;
    const TestSurface sphere = surface_of_shapes({"sphere"}, 20000);
    Renderer renderer;
    renderer.upload(sphere.mesh, sphere.form);
    for (const int samples : {1, 4}) {
        OffscreenTarget target(640, 480, samples);
        const Camera camera = camera_on(sphere, target);
        const Picture picture = take_picture(renderer, target, camera, one);
        const Picture background = background_of(target);
        const double distance = glm::length(camera.eye());
        const double field = std::tan(glm::radians(static_cast<double>(vertical_field_degrees) / 2));
        const double radius = 240 / field / std::sqrt(distance * distance - 1);
        const double area = std::numbers::pi * radius * radius;
        const double rim = samples > 1 ? std::numbers::pi * radius : 0;  // half-covered pixels count as well
        CHECK(count_differences(picture, background) == doctest::Approx(area + rim).epsilon(0.01));
    }
}

TEST_CASE("light comes from above left, and the background stays darker than the lit surface") {
    const EglContext context;
    const TestSurface sphere = surface_of_shapes({"sphere"}, 5000);
    Renderer renderer;
    renderer.upload(sphere.mesh, sphere.form);
    OffscreenTarget target(300, 300, 4);
    const Picture picture = take_picture(renderer, target, camera_on(sphere, target), one);
    const auto brightness = [&](int x, int y) { return glm::dot(picture.light(x, y), glm::vec3(1)); };
    CHECK(brightness(110, 100) > 2 * brightness(200, 210));
    CHECK(brightness(110, 100) > 4 * brightness(2, 2));
    CHECK(brightness(2, 2) > 2 * brightness(2, 297));
}

TEST_CASE("flat shading gives each face one color") {
    const EglContext context;
    const TestSurface icosahedron = surface_of_shapes({"icosahedron"}, 20);
    Renderer renderer;
    renderer.upload(icosahedron.mesh, icosahedron.form);
    OffscreenTarget target(320, 240, 1);
    const Camera camera = camera_on(icosahedron, target);
    Display display;
    const Picture smooth = take_picture(renderer, target, camera, one, display);
    display.shading = Shading::flat;
    const Picture flat = take_picture(renderer, target, camera, one, display);
    const std::size_t of_background = distinct_colors(background_of(target));
    CHECK(distinct_colors(smooth) > of_background + 300);
    // The highlight varies a little over a face.
    CHECK(distinct_colors(flat) < of_background + 80);
    CHECK(count_differences(smooth, flat, 8) > 2000);
}

TEST_CASE("where the normal vanishes, smooth shading uses the face normal") {
    const EglContext context;
    TestSurface sphere = surface_of_shapes({"sphere"}, 500);
    std::ranges::fill(sphere.form.products, glm::vec3(0));
    Renderer renderer;
    renderer.upload(sphere.mesh, sphere.form);
    OffscreenTarget target(320, 240, 1);
    const Camera camera = camera_on(sphere, target);
    Display display;
    const Picture smooth = take_picture(renderer, target, camera, one, display);
    display.shading = Shading::flat;
    CHECK(take_picture(renderer, target, camera, one, display) == smooth);
}

TEST_CASE("the back of an open surface is visible, and darker") {
    const EglContext context;
    const TestSurface square = surface_of(two_keys_of_a_square());
    Renderer renderer;
    renderer.upload(square.mesh, square.form);
    OffscreenTarget target(200, 200, 1);
    const Picture front = take_picture(renderer, target, camera_on(square, target, 0, 0), both);
    const Picture back = take_picture(renderer, target, camera_on(square, target, 180, 0), both);
    const Picture background = background_of(target);
    CHECK(count_differences(front, background) ==
          doctest::Approx(count_differences(back, background)).epsilon(0.02));
    const float seen = glm::dot(back.light(100, 100), glm::vec3(1));
    CHECK(seen < 0.8F * glm::dot(front.light(100, 100), glm::vec3(1)));
    CHECK(seen > 0.2F * glm::dot(front.light(100, 100), glm::vec3(1)));
}

TEST_CASE("colors by level and by origin are those of the legend") {
    const EglContext context;
    const TestSurface square = surface_of(two_keys_of_a_square());
    const UnionMesh& mesh = square.mesh;
    REQUIRE(mesh.leaf_count() > 4);
    Renderer renderer;
    renderer.upload(mesh, square.form);
    OffscreenTarget target(400, 400, 1);
    const Camera camera = camera_on(square, target, 0, 0);
    Display display;
    const Picture plain = take_picture(renderer, target, camera, both, display);

    display.coloring = Coloring::level;
    const LevelRange levels = level_range(mesh);
    REQUIRE(levels.min < levels.max);
    check_leaf_colors(mesh, camera, plain, plain_color, take_picture(renderer, target, camera, both, display),
                      [&](std::size_t leaf) { return level_color(mesh.tags[leaf].level(), levels); });

    display.coloring = Coloring::origin;
    const std::size_t keys[] = {3, 5};
    renderer.upload(mesh, square.form, keys);
    check_leaf_colors(mesh, camera, plain, plain_color, take_picture(renderer, target, camera, both, display),
                      [&](std::size_t leaf) { return origin_color(mesh.origins[leaf], keys); });
}

TEST_CASE("each origin of a union is visible in its color") {
    const EglContext context;
    const TestSurface surface = surface_of_shapes({"star", "bone", "cushion"}, 3000);
    Renderer renderer;
    renderer.upload(surface.mesh, surface.form);
    OffscreenTarget target(640, 480, 4);
    const Camera camera = camera_on(surface, target);
    const float weights[] = {0.4F, 0.3F, 0.3F};
    Display display;
    const Picture plain = take_picture(renderer, target, camera, weights, display);
    display.coloring = Coloring::origin;
    const Picture picture = take_picture(renderer, target, camera, weights, display);
    const std::size_t keys[] = {0, 1, 2};
    for (std::size_t key = 0; key < 3; ++key) {
        CAPTURE(key);
        const glm::vec3 color = linear_light(key_color(key));
        const auto has_hue = [&](glm::vec3 light) {
            const float sum = glm::dot(light, glm::vec3(1));
            return sum > 0.15F && glm::distance(light / sum, color / glm::dot(color, glm::vec3(1))) < 0.06F;
        };
        CHECK(origin_color(key_bit(key), keys) == key_color(key));
        CHECK(count_pixels(plain, has_hue) == 0);
        CHECK(count_pixels(picture, has_hue) > 200);
    }
}

TEST_CASE("reloaded shaders draw the same picture") {
    const EglContext context;
    const TestSurface sphere = surface_of_shapes({"sphere"}, 500);
    Renderer renderer;
    renderer.upload(sphere.mesh, sphere.form);
    OffscreenTarget target(160, 120, 1);
    const Camera camera = camera_on(sphere, target);
    const Picture before = take_picture(renderer, target, camera, one);
    renderer.reload_shaders();
    CHECK(take_picture(renderer, target, camera, one) == before);
}
