// Tests of the text of a view.
#include "app/document/viewpoint.h"

#include <random>
#include <string>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "hierarchy/error.h"

using namespace interleaf;

TEST_CASE("a view is read from its text in every form") {
    CHECK(parse_viewpoint("10,-20") == Viewpoint{.direction = {10, -20, 0}});
    CHECK(parse_viewpoint("10,-20,2.5") == Viewpoint{.direction = {10, -20, 0}, .zoom = 2.5F});
    CHECK(parse_viewpoint("10,20,roll=-30,center=1:2:-3e-1,distance=4,orthographic") ==
          Viewpoint{.direction = {10, 20, -30},
                    .center = glm::vec3(1, 2, -0.3F),
                    .distance = 4.0F,
                    .projection = Projection::orthographic});
    CHECK(parse_viewpoint("10,20,up=z") == Viewpoint{.direction = {10, 20, 0}, .up = UpAxis::z});
    CHECK(parse_viewpoint("0,0,perspective") == Viewpoint{.direction = {0, 0, 0}});
}

TEST_CASE("a text that is no view is refused, and the message says what was expected") {
    for (const char* text : {"",
                             "10",
                             "10,91",
                             "-361,0",
                             "10,20,0",
                             "10,20,101",
                             "10,20,2,3",
                             "a,b",
                             "10,20,roll",
                             "10,20,roll=",
                             "10,20,roll=nan",
                             "10,20,center=1:2",
                             "10,20,center=1:2:inf",
                             "10,20,distance=0",
                             "10,20,distance=-1",
                             "10,20,distance=1e99",
                             "10,20,fisheye",
                             "10,20,",
                             "10,20,orthographic=1",
                             "10,20,up=W",
                             "10,20,up"}) {
        CAPTURE(text);
        CHECK_THROWS_AS(parse_viewpoint(text), UsageError);
    }
    CHECK_THROWS_WITH_AS(parse_viewpoint("10,20,roll=x"), "expected a roll from -360 to 360, got 'x'",
                         UsageError);
}

TEST_CASE("the text of a camera gives the same camera, to the last bit") {
    const unsigned seed = 23;
    CAPTURE(seed);
    std::mt19937 generator(seed);
    const auto random = [&](float low, float high) {
        return std::uniform_real_distribution<float>(low, high)(generator);
    };
    const Extent scene = extent_of({glm::vec3(-1), glm::vec3(2)});
    for (int i = 0; i < 200; ++i) {
        Camera camera;
        if (i % 2 == 1) camera.set_projection(Projection::orthographic);
        camera.set_up(static_cast<UpAxis>(i % 3));
        camera.view_all(scene, 1.5F);
        camera.orbit({random(-1, 1), random(-1, 1)},
                     i % 3 == 0 ? OrbitStyle::trackball : OrbitStyle::turntable);
        camera.pan({random(-0.2F, 0.2F), random(-0.2F, 0.2F)});
        camera.approach(random(0.5F, 4), {random(-1, 1), random(-1, 1), 0});
        const std::string text = text_of(viewpoint_of(camera));
        CAPTURE(text);
        CHECK(camera_at(scene, parse_viewpoint(text), 0.7F) == camera);
    }
}

TEST_CASE("at zoom 2 the camera is at half the distance of zoom 1") {
    const Extent scene = extent_of({glm::vec3(-1), glm::vec3(1)});
    const Camera once = camera_at(scene, {}, 1);
    const Camera twice = camera_at(scene, {.zoom = 2}, 1);
    CHECK(twice.distance() == doctest::Approx(once.distance() / 2));
    CHECK(twice.target() == once.target());
}
