// Tests of the ground and its shadow, and of the materials and backgrounds that go with it.
#include "render/ground.h"

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "hierarchy/measure.h"
#include "render/context.h"
#include "render/picture.h"
#include "render/test_surfaces.h"

namespace interleaf {
namespace {

float brightness(glm::vec3 light) {
    return light.r + light.g + light.b;
}

/// A sphere seen from \p elevation, alone and above the ground, before a light background.
struct Grounded {
    TestSurface surface = surface_of_shapes({"sphere"}, 2000);
    Box box = bounding_box(surface.mesh.positions.front());
    Camera camera{};
    Picture alone{};
    Picture above{};

    explicit Grounded(float elevation, float lifted = 0, Projection projection = Projection::perspective) {
        Renderer renderer;
        renderer.upload(surface.mesh, surface.form);
        OffscreenTarget target(320, 240, 4);
        camera = camera_on(surface, target, 30, elevation);
        camera.set_projection(projection);
        camera.zoom(0.5F, {0, 0}, 320.0F / 240);
        const Display display{.light_background = true};
        alone = take_picture(renderer, target, camera, one, display);
        Ground ground;
        box.min.y -= lifted;
        ground.cast_shadow(renderer, one, box);
        ground.draw(target, camera, true);
        above = {target.width(), target.height(), target.read_rgba()};
    }

    /// The light of the ground at the distance \p aside from its center, towards +x.
    float light_at(float aside) const {
        const glm::vec2 pixel = pixel_of(camera, above, {box.center().x + aside, box.min.y, box.center().z});
        return brightness(above.light(static_cast<int>(pixel.x), static_cast<int>(pixel.y)));
    }
};

}  // namespace

TEST_CASE("the shadow is darker, the closer the surface is to the ground") {
    const EglContext context;
    const Grounded touching(60);
    const Grounded lifted(60, 3);
    const float radius = (touching.box.max.x - touching.box.min.x) / 2;
    CHECK(touching.light_at(1.1F * radius) < 0.95F * lifted.light_at(1.1F * radius));
    CHECK(count_differences(touching.alone, touching.above, 8) > 2000);
}

TEST_CASE("the ground lies behind the surface, and is not seen from below") {
    const EglContext context;
    const Grounded beside(20);
    const glm::vec2 top = pixel_of(beside.camera, beside.above, {0, beside.box.max.y - 0.3F, 0});
    CHECK(beside.alone.light(static_cast<int>(top.x), static_cast<int>(top.y)) ==
          beside.above.light(static_cast<int>(top.x), static_cast<int>(top.y)));
    const Grounded below(-30);
    CHECK(below.alone == below.above);
}

TEST_CASE("parallel rays from below do not see the ground, wherever the camera stands") {
    const EglContext context;
    const Grounded below(-5, 0, Projection::orthographic);
    CHECK(below.alone == below.above);
    const Grounded above(20, 0, Projection::orthographic);
    CHECK(count_differences(above.alone, above.above, 8) > 2000);
}

TEST_CASE("with Z up the picture is that of the turned surface with Y up, with its ground") {
    const EglContext context;
    TestSurface upright = surface_of_shapes({"star"}, 2000);
    TestSurface turned = upright;
    for (glm::vec3& position : turned.mesh.positions.front()) position = axes_with(UpAxis::z) * position;
    turned.form = normal_form(turned.mesh);
    const auto picture_of = [](const TestSurface& surface, UpAxis up) {
        Renderer renderer;
        renderer.upload(surface.mesh, surface.form);
        OffscreenTarget target(160, 120, 4);
        Camera camera;
        camera.set_up(up);
        camera.look_from(30, 20);
        const Box box = bounding_box(surface.mesh.positions.front());
        camera.view_all(extent_of(box), 160.0F / 120);
        renderer.draw(target, camera, one, {.light_background = true});
        Ground ground;
        ground.cast_shadow(renderer, one, box, up);
        ground.draw(target, camera, true);
        return Picture{target.width(), target.height(), target.read_rgba()};
    };
    const Picture as_y = picture_of(upright, UpAxis::y);
    CHECK(count_differences(as_y, picture_of(turned, UpAxis::z), 8) < 100);
    CHECK(count_differences(as_y, picture_of(turned, UpAxis::y), 8) > 2000);
}

TEST_CASE("each material looks different, but only on a plain surface") {
    const EglContext context;
    const TestSurface surface = surface_of_shapes({"star"}, 2000);
    Renderer renderer;
    renderer.upload(surface.mesh, surface.form);
    OffscreenTarget target(160, 120, 1);
    const Camera camera = camera_on(surface, target);
    std::vector<Picture> pictures;
    for (const Material material : materials()) {
        pictures.push_back(take_picture(renderer, target, camera, one, {.material = material}));
        for (std::size_t other = 0; other + 1 < pictures.size(); ++other)
            CHECK(count_differences(pictures.back(), pictures[other], 20) > 1000);
    }
    const auto by_level = [&](Material material) {
        return take_picture(renderer, target, camera, one,
                            {.coloring = Coloring::level, .material = material});
    };
    CHECK(by_level(Material::steel) == by_level(Material::clay));
}

TEST_CASE("parallel rays show each material of a plane evenly") {
    const EglContext context;
    const TestSurface square = surface_of(two_keys_of_a_square());
    Renderer renderer;
    renderer.upload(square.mesh, square.form);
    OffscreenTarget target(160, 120, 1);
    Camera camera = camera_on(square, target, 0, 0);
    camera.set_projection(Projection::orthographic);
    const float first_key[] = {1, 0};
    for (const Material material : materials()) {
        const Picture picture = take_picture(renderer, target, camera, first_key, {.material = material});
        const auto light_at = [&](glm::vec3 point) {
            const glm::vec2 pixel = pixel_of(camera, picture, point);
            return brightness(picture.light(static_cast<int>(pixel.x), static_cast<int>(pixel.y)));
        };
        CHECK(light_at({-0.8F, -0.7F, 0}) == doctest::Approx(light_at({0.8F, 0.7F, 0})).epsilon(0.02));
    }
}

TEST_CASE("a light background is light, and the surface before it stays the same") {
    const EglContext context;
    const TestSurface surface = surface_of_shapes({"sphere"}, 500);
    Renderer renderer;
    renderer.upload(surface.mesh, surface.form);
    OffscreenTarget target(160, 120, 1);
    const Camera camera = camera_on(surface, target);
    const Picture dark = take_picture(renderer, target, camera, one);
    const Picture light = take_picture(renderer, target, camera, one, {.light_background = true});
    CHECK(brightness(dark.light(2, 2)) < 0.5F);
    CHECK(brightness(light.light(2, 2)) > 1.5F);
    CHECK(dark.light(80, 60) == light.light(80, 60));
}

}  // namespace interleaf
