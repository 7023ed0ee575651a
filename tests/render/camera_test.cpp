// Tests of the camera without OpenGL.
#include "render/camera.h"

#include <algorithm>
#include <cmath>
#include <random>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

using namespace interleaf;

namespace {

constexpr float aspect = 1.6F;

glm::vec3 device_coordinates(const Camera& camera, glm::vec3 point, float at_aspect = aspect) {
    const glm::vec4 clip = camera.projection(at_aspect) * camera.view() * glm::vec4(point, 1);
    return glm::vec3(clip) / clip.w;
}

float random(std::mt19937& generator, float low, float high) {
    return std::uniform_real_distribution<float>(low, high)(generator);
}

glm::vec3 random_point(std::mt19937& generator, float size) {
    return {random(generator, -size, size), random(generator, -size, size), random(generator, -size, size)};
}

Camera looking_at_unit_box(float azimuth = 30, float elevation = 20) {
    Camera camera;
    camera.look_from(azimuth, elevation);
    camera.view_all(extent_of({glm::vec3(-1), glm::vec3(1)}), aspect);
    return camera;
}

}  // namespace

TEST_CASE("a box in view lies in the picture and fills it, for any size, direction and aspect") {
    const unsigned seed = 7;
    CAPTURE(seed);
    std::mt19937 generator(seed);
    for (int i = 0; i < 500; ++i) {
        const float size = std::exp(random(generator, -8, 8));
        const glm::vec3 a = random_point(generator, size);
        const glm::vec3 b = random_point(generator, size);
        const Box box{glm::min(a, b), glm::max(a, b)};
        const float at_aspect = random(generator, 0.4F, 2.5F);
        Camera camera;
        camera.look_from(random(generator, -180, 180), random(generator, -90, 90));
        camera.view_all(extent_of(box), at_aspect);
        float reach = 0;
        for (int corner = 0; corner < 8; ++corner) {
            const glm::vec3 point((corner & 1) != 0 ? a.x : b.x, (corner & 2) != 0 ? a.y : b.y,
                                  (corner & 4) != 0 ? a.z : b.z);
            const glm::vec3 seen = device_coordinates(camera, point, at_aspect);
            reach = std::max({reach, std::abs(seen.x), std::abs(seen.y)});
            CHECK(std::abs(seen.z) < 1);
        }
        CHECK(reach < 1);
        CHECK(reach > 0.9F);
    }
}

TEST_CASE("a ball in view fills the picture, while its box extends beyond it") {
    for (const float at_aspect : {0.5F, 1.0F, 1.8F}) {
        CAPTURE(at_aspect);
        Camera camera;
        camera.look_from(35, 25);
        camera.view_all({.box = {glm::vec3(-1), glm::vec3(1)}, .radius = 1}, at_aspect);
        float reach = 0;
        for (int i = 0; i < 10000; ++i) {  // a spiral over the ball
            const float y = 1 - 2 * (static_cast<float>(i) + 0.5F) / 10000;
            const float turn = 2.4F * static_cast<float>(i);
            const float width = std::sqrt(1 - y * y);
            const glm::vec3 seen =
                device_coordinates(camera, {width * std::cos(turn), y, width * std::sin(turn)}, at_aspect);
            reach = std::max({reach, std::abs(seen.x), std::abs(seen.y)});
        }
        CHECK(reach < 1);
        CHECK(reach > 0.9F);
    }
}

TEST_CASE("a box of no size can be brought into view") {
    Camera camera;
    camera.view_all(extent_of({glm::vec3(2), glm::vec3(2)}), aspect);
    const glm::vec3 seen = device_coordinates(camera, glm::vec3(2));
    CHECK(std::abs(seen.x) < 1e-4F);
    CHECK(std::abs(seen.z) < 1);
}

TEST_CASE("azimuth turns about Y from +Z, elevation lifts towards +Y") {
    const auto direction = [](float azimuth, float elevation) {
        return glm::normalize(looking_at_unit_box(azimuth, elevation).eye());
    };
    CHECK(glm::distance(direction(0, 0), {0, 0, 1}) < 1e-5F);
    CHECK(glm::distance(direction(90, 0), {1, 0, 0}) < 1e-5F);
    CHECK(glm::distance(direction(0, 90), {0, 1, 0}) < 1e-5F);
    CHECK(glm::distance(direction(0, -45), glm::normalize(glm::vec3(0, -1, 1))) < 1e-5F);
}

TEST_CASE("orbiting keeps the distance, follows the pointer and stops at the poles") {
    Camera camera = looking_at_unit_box(0, 0);
    const float distance = glm::length(camera.eye());
    const glm::vec3 front(0, 0, 1);
    camera.orbit({0.05F, 0.02F});
    CHECK(glm::length(camera.eye()) == doctest::Approx(distance));
    CHECK(device_coordinates(camera, front).x > 0);
    CHECK(device_coordinates(camera, front).y < 0);
    camera.orbit({0, 10});
    CHECK(glm::distance(glm::normalize(camera.eye()), {0, 1, 0}) < 1e-5F);
    // No roll: the world's vertical stays upright in the picture, or becomes a point at the pole.
    camera.orbit({0.3F, -0.2F});
    const glm::vec4 up = camera.view() * glm::vec4(0, 1, 0, 0);
    CHECK(std::abs(up.x) < 1e-5F);
    CHECK(up.y > 0);
}

TEST_CASE("panning keeps the point under the pointer") {
    Camera camera = looking_at_unit_box();
    const glm::vec3 before = device_coordinates(camera, glm::vec3(0));
    const glm::vec2 delta(0.17F, -0.08F);  // in units of the picture's height, y down
    camera.pan(delta);
    const glm::vec3 after = device_coordinates(camera, glm::vec3(0));
    CHECK(after.x - before.x == doctest::Approx(2 * delta.x / aspect).epsilon(1e-4));
    CHECK(after.y - before.y == doctest::Approx(-2 * delta.y).epsilon(1e-4));
}

TEST_CASE("a centered point is in the middle of the picture, at the same direction and distance") {
    std::mt19937 generator(13);
    for (int i = 0; i < 100; ++i) {
        Camera camera = looking_at_unit_box(random(generator, -180, 180), random(generator, -80, 80));
        const Camera before = camera;
        const glm::vec3 point = random_point(generator, 1);
        camera.center(point);
        const glm::vec3 seen = device_coordinates(camera, point);
        CHECK(std::abs(seen.x) < 1e-5F);
        CHECK(std::abs(seen.y) < 1e-5F);
        CHECK(seen.z == doctest::Approx(device_coordinates(before, point).z).epsilon(1e-4));
        CHECK(glm::mat3(camera.view()) == glm::mat3(before.view()));
    }
}

TEST_CASE("zooming and approaching keep the point under the pointer and come nearer by the factor") {
    const unsigned seed = 11;
    CAPTURE(seed);
    std::mt19937 generator(seed);
    for (int i = 0; i < 200; ++i) {
        Camera camera = looking_at_unit_box(random(generator, -180, 180), random(generator, -80, 80));
        const glm::vec2 pointer(random(generator, -0.9F, 0.9F), random(generator, -0.9F, 0.9F));
        const float factor = random(generator, 0.5F, 4);
        Camera zoomed = camera;
        zoomed.zoom(factor, pointer, aspect);
        const glm::vec3 center_depth = device_coordinates(camera, glm::vec3(0));
        const glm::vec3 under_pointer = camera.point_at(pointer, (center_depth.z + 1) / 2, aspect);
        const glm::vec3 seen = device_coordinates(zoomed, under_pointer);
        CHECK(glm::distance(glm::vec2(seen), pointer) < 1e-3F);
        CHECK(glm::distance(zoomed.eye(), under_pointer) * factor ==
              doctest::Approx(glm::distance(camera.eye(), under_pointer)).epsilon(1e-3));

        const glm::vec3 point = random_point(generator, 0.5F);
        Camera nearer = camera;
        nearer.approach(factor, point);
        CHECK(glm::distance(glm::vec2(device_coordinates(nearer, point)),
                            glm::vec2(device_coordinates(camera, point))) < 1e-3F);
        CHECK(glm::distance(nearer.eye(), point) * factor ==
              doctest::Approx(glm::distance(camera.eye(), point)).epsilon(1e-3));
    }
}

TEST_CASE("the point under the pointer has the pointer's coordinates and depth") {
    const Camera camera = looking_at_unit_box(200, -35);
    for (const float depth : {0.1F, 0.5F, 0.9F}) {
        const glm::vec3 seen = device_coordinates(camera, camera.point_at({0.3F, -0.6F}, depth, aspect));
        CHECK(glm::distance(seen, {0.3F, -0.6F, 2 * depth - 1}) < 1e-3F);
    }
}

TEST_CASE("a surface point that is approached a thousandfold is still between the clipping planes") {
    Camera camera = looking_at_unit_box(0, 0);
    const glm::vec3 point(0.1F, 0.2F, 1);
    for (int i = 0; i < 40; ++i) {
        camera.approach(1.2F, point);
        CHECK(std::abs(device_coordinates(camera, point).z) < 1);
    }
}

TEST_CASE("a trackball turns the surface with the pointer from every direction, without end") {
    const unsigned seed = 17;
    CAPTURE(seed);
    std::mt19937 generator(seed);
    for (int i = 0; i < 200; ++i) {
        Camera camera = looking_at_unit_box();
        camera.look_from(
            {random(generator, -180, 180), random(generator, -90, 90), random(generator, -180, 180)});
        const glm::mat3 before = camera.axes();
        const glm::vec3 nearest = before[2];  // the point of the unit ball in the middle of the picture
        const glm::vec2 delta(random(generator, -0.1F, 0.1F), random(generator, -0.1F, 0.1F));
        camera.orbit(delta, OrbitStyle::trackball);
        const glm::vec3 seen = glm::transpose(camera.axes()) * nearest;
        const float angle = glm::radians(180.0F) * glm::length(delta);
        CHECK(seen.z == doctest::Approx(std::cos(angle)).epsilon(1e-4));
        CHECK(glm::distance(glm::vec2(seen), std::sin(angle) * glm::normalize(glm::vec2(delta.x, -delta.y))) <
              1e-4F);
        camera.orbit(-delta, OrbitStyle::trackball);
        for (int axis = 0; axis < 3; ++axis) CHECK(glm::distance(camera.axes()[axis], before[axis]) < 1e-4F);
    }
    Camera over_the_pole = looking_at_unit_box(0, 80);
    over_the_pole.orbit({0, 20 / 180.0F}, OrbitStyle::trackball);
    CHECK(glm::distance(over_the_pole.axes()[2], looking_at_unit_box(180, 80).axes()[2]) < 1e-4F);
}

TEST_CASE("a roll turns the picture counterclockwise, and a turntable drag still follows the pointer") {
    Camera camera = looking_at_unit_box(0, 0);
    camera.roll(90);
    const glm::vec3 right = device_coordinates(camera, {1, 0, 0});
    CHECK(std::abs(right.x) < 1e-4F);
    CHECK(right.y > 0.1F);
    const glm::vec3 front(0, 0, 1);
    camera.orbit({0.05F, 0.02F});
    const glm::vec3 moved = device_coordinates(camera, front);
    CHECK(moved.x * aspect / -moved.y == doctest::Approx(2.5).epsilon(0.05));
    CHECK(moved.x > 0);
    camera.roll(-90);
    CHECK(camera.direction().roll == 0);
}

TEST_CASE("an orthographic camera shows the target as large, whatever is nearer, and nothing is clipped") {
    Camera camera = looking_at_unit_box(0, 0);
    const glm::vec3 perspective = device_coordinates(camera, {0, 0.5F, 0});
    camera.set_projection(Projection::orthographic);
    CHECK(device_coordinates(camera, {0, 0.5F, 0}).y == doctest::Approx(perspective.y));
    CHECK(device_coordinates(camera, {0, 0.5F, 1}).y == doctest::Approx(perspective.y));
    for (int zoom = 0; zoom < 60; ++zoom) {
        camera.approach(1.12F, {0, 0, 0});
        for (const float z : {-1.0F, 0.0F, 1.0F})
            CHECK(std::abs(device_coordinates(camera, {0, 0, z}).z) < 1);
    }
    camera.view_all(extent_of({glm::vec3(-1), glm::vec3(1)}), aspect);
    CHECK(device_coordinates(camera, {1, 1, 1}).y > 0.9F);
    CHECK(device_coordinates(camera, {1, 1, 1}).y < 1);
}

TEST_CASE("neither shifts nor zooms lose the scene") {
    const unsigned seed = 19;
    CAPTURE(seed);
    std::mt19937 generator(seed);
    const float radius = std::sqrt(3.0F);
    for (const Projection projection : {Projection::perspective, Projection::orthographic}) {
        Camera camera = looking_at_unit_box();
        camera.set_projection(projection);
        for (int i = 0; i < 2000; ++i) {
            const glm::vec2 pointer(random(generator, -1, 1), random(generator, -1, 1));
            camera.pan({random(generator, -1, 1), random(generator, -1, 1)});
            camera.orbit({random(generator, -1, 1), random(generator, -1, 1)}, OrbitStyle::trackball);
            camera.zoom(std::exp(random(generator, -2, 2)), pointer, aspect);
            const glm::vec3 offset = glm::transpose(camera.axes()) * (camera.target() - glm::vec3(0));
            const float shown = camera.height_at(camera.distance()) / 2;
            REQUIRE(glm::length(glm::vec2(offset)) < radius + shown);
            REQUIRE(std::abs(offset.z) < 1.01F * radius);
            REQUIRE(shown < 15 * radius);
            REQUIRE(camera.distance() > 0.019F * radius);
        }
    }
}

TEST_CASE("a part of the scene is framed, and the rest is not clipped") {
    Camera camera = looking_at_unit_box(0, 0);
    camera.frame(extent_of({{0.5F, 0.5F, 0.5F}, {0.6F, 0.6F, 0.6F}}), aspect);
    const glm::vec3 top = device_coordinates(camera, {0.55F, 0.6F, 0.6F});
    CHECK(top.y > 0.8F);
    CHECK(top.y < 1);
    CHECK(device_coordinates(camera, {0, 0, -1}).z < 1);
}

TEST_CASE("each axis can point up: upright views show it vertical, and the top view looks down along it") {
    for (const UpAxis up : {UpAxis::x, UpAxis::y, UpAxis::z}) {
        CAPTURE(name_of(up));
        const glm::vec3 vertical = axes_with(up)[1];
        CHECK(vertical[static_cast<int>(up)] == 1);
        Camera camera;
        camera.set_up(up);
        for (const float azimuth : {0.0F, 30.0F, 180.0F, -75.0F}) {
            camera.look_from(azimuth, 20);
            CHECK(std::abs(glm::dot(camera.axes()[0], vertical)) < 1e-6F);
            CHECK(glm::dot(camera.axes()[1], vertical) > 0.9F);
            const glm::vec3 before = camera.axes()[2];
            camera.turn(40);
            CHECK(glm::dot(camera.axes()[2], vertical) == doctest::Approx(glm::dot(before, vertical)));
        }
        camera.look_from(0, 90);
        CHECK(glm::distance(camera.axes()[2], vertical) < 1e-6F);
    }
}

TEST_CASE("with Z up the front is the negative end of Y") {
    Camera camera;
    camera.set_up(UpAxis::z);
    camera.look_from(0, 0);
    CHECK(glm::distance(camera.axes()[2], {0, -1, 0}) < 1e-6F);
    CHECK(glm::distance(camera.axes()[0], {1, 0, 0}) < 1e-6F);
}

TEST_CASE("a plane is seen from its front, not mirrored, whatever axis points up") {
    for (const UpAxis up : {UpAxis::x, UpAxis::y, UpAxis::z})
        for (unsigned axis = 0; axis < 3; ++axis) {
            CAPTURE(name_of(up));
            CAPTURE(axis);
            const glm::vec3 front = front_of_plane(axis, up);
            CHECK(glm::length(front) == 1);
            CHECK(glm::dot(front, axes_with(up)[2]) >= 0);
        }
    CHECK(front_of_plane(1, UpAxis::y) == glm::vec3(0, 1, 0));
    CHECK(front_of_plane(2, UpAxis::y) == glm::vec3(0, 0, 1));
    CHECK(front_of_plane(2, UpAxis::z) == glm::vec3(0, 0, 1));
    Camera camera;
    camera.set_up(UpAxis::z);
    camera.look_from_end(front_of_plane(1, UpAxis::z));
    CHECK(glm::distance(camera.axes()[0], {1, 0, 0}) < 1e-6F);
    CHECK(glm::distance(camera.axes()[1], {0, 0, 1}) < 1e-6F);
}

TEST_CASE("a trackball turns the same, whatever axis points up") {
    Camera camera;
    camera.look_from({25, -30, 10});
    Camera other = camera;
    other.set_up(UpAxis::z);
    const glm::mat3 turn = axes_with(UpAxis::z);
    for (const glm::vec2 delta : {glm::vec2(0.2F, 0), glm::vec2(-0.1F, 0.3F), glm::vec2(0, -0.4F)}) {
        camera.orbit(delta, OrbitStyle::trackball);
        other.orbit(delta, OrbitStyle::trackball);
        for (int axis = 0; axis < 3; ++axis)
            CHECK(glm::distance(turn * camera.axes()[axis], other.axes()[axis]) < 1e-4F);
    }
}

TEST_CASE("a look from the end of an axis is along it, whatever axis points up") {
    for (const UpAxis up : {UpAxis::x, UpAxis::y, UpAxis::z})
        for (int axis = 0; axis < 3; ++axis)
            for (const float sign : {1.0F, -1.0F}) {
                glm::vec3 from(0);
                from[axis] = sign;
                Camera camera;
                camera.set_up(up);
                camera.look_from_end(from);
                CHECK(glm::distance(camera.axes()[2], from) < 1e-6F);
            }
}

TEST_CASE("a look from above or below has no turn of its own, also where zeros have a sign") {
    for (const float sign : {1.0F, -1.0F})
        for (const glm::vec3 from : {glm::vec3(0, sign, 0), -glm::vec3(0, -sign, 0)}) {
            Camera camera;
            camera.look_from_end(from);
            Camera expected;
            expected.look_from(0, sign * 90);
            CHECK(glm::distance(camera.axes()[1], expected.axes()[1]) < 1e-6F);
        }
}
