// Tests of colorings by values that the blend determines, and of marks at vertices.
#include "render/surface_values.h"

#include <algorithm>

#include <doctest/doctest.h>

#include "hierarchy/morph.h"
#include "render/context.h"
#include "render/picture.h"
#include "render/test_surfaces.h"

using namespace interleaf;

namespace {

constexpr float halves[] = {0.5F, 0.5F};

Display colored(Coloring coloring, const UnionMesh& mesh) {
    Display display;
    display.coloring = coloring;
    display.scale = measured_scale(coloring, mesh);
    return display;
}

}  // namespace

TEST_CASE("the scales cover the keys, and a surface that does not move has a scale, too") {
    const TestSurface two = surface_of_shapes({"star", "sphere"}, 400);
    const ValueRange moved = measured_scale(Coloring::moved, two.mesh).range;
    CHECK(moved.min == 0);
    const SurfaceValues at_second = surface_values(Coloring::moved, two.mesh, two.mesh.positions[1]);
    CHECK(moved.max == std::ranges::max(at_second.values));
    CHECK(std::ranges::max(surface_values(Coloring::moved, two.mesh, two.mesh.positions[0]).values) == 0);
    const ValueRange curvature = measured_scale(Coloring::curvature, two.mesh).range;
    CHECK(curvature.min == -curvature.max);
    CHECK(curvature.max > 0);
    const TestSurface one_key = surface_of_shapes({"sphere"}, 400);
    const ValueRange unmoved = measured_scale(Coloring::moved, one_key.mesh).range;
    CHECK(unmoved.max > unmoved.min);
    CHECK(surface_values(Coloring::angle, two.mesh, two.mesh.positions[0]).values.size() ==
          two.mesh.leaf_count());
    CHECK(surface_values(Coloring::curvature, two.mesh, two.mesh.positions[0]).values.size() ==
          two.mesh.vertex_count());
}

TEST_CASE(
    "a value per leaf and a value per vertex give the color of the value, and none gives the plain color") {
    const EglContext context;
    const TestSurface surface = surface_of_shapes({"star", "sphere"}, 400);
    Renderer renderer;
    renderer.upload(surface.mesh, surface.form);
    OffscreenTarget target(200, 150, 1);
    const Camera camera = camera_on(surface, target);
    const Display angle = colored(Coloring::angle, surface.mesh);
    const Picture plain = take_picture(renderer, target, camera, halves);
    CHECK(count_differences(take_picture(renderer, target, camera, halves, angle), plain, 2) == 0);

    const auto picture_of = [&](ValuePlace place, std::size_t count, float value) {
        renderer.set_values({place, std::vector<float>(count, value)});
        return take_picture(renderer, target, camera, halves, angle);
    };
    const Picture per_leaf = picture_of(ValuePlace::leaf, surface.mesh.leaf_count(), 20);
    const Picture per_vertex = picture_of(ValuePlace::vertex, surface.mesh.vertex_count(), 20);
    CHECK(count_differences(per_leaf, per_vertex, 1) == 0);
    CHECK(count_differences(per_leaf, plain, 8) > 1000);
    CHECK(count_differences(per_leaf, picture_of(ValuePlace::leaf, surface.mesh.leaf_count(), 50), 8) > 1000);

    // The values of each coloring give a picture of their own, with lines, too.
    for (const Coloring coloring : {Coloring::angle, Coloring::curvature, Coloring::moved}) {
        Display display = colored(coloring, surface.mesh);
        display.wireframe = coloring == Coloring::angle;
        renderer.set_values(surface_values(coloring, surface.mesh, morph(surface.mesh, halves)));
        CHECK(count_differences(take_picture(renderer, target, camera, halves, display), per_leaf, 8) > 1000);
    }
    renderer.set_field(nullptr);
    CHECK(count_differences(take_picture(renderer, target, camera, halves, angle), plain, 2) == 0);
}

TEST_CASE("vertices and normals are drawn where the surface is seen, and leave its depths as they are") {
    const EglContext context;
    const TestSurface surface = surface_of_shapes({"sphere"}, 80);
    Renderer renderer;
    renderer.upload(surface.mesh, surface.form);
    OffscreenTarget target(320, 240, 1);
    const Camera camera = camera_on(surface, target);
    const Picture plain = take_picture(renderer, target, camera, one);
    const std::vector<float> depths = target.read_depths();
    Display display;
    display.vertices = true;
    const Picture dots = take_picture(renderer, target, camera, one, display);
    const int dotted = count_differences(dots, plain, 8);
    CHECK(dotted > 100);
    CHECK(dotted < 3000);
    CHECK(target.read_depths() == depths);
    display = {};
    display.normals = true;
    const Picture lines = take_picture(renderer, target, camera, one, display);
    CHECK(count_differences(lines, plain, 8) > 300);
    CHECK(count_differences(lines, dots, 8) > 300);
    // The dot of each vertex that faces the camera is at its place.
    int seen = 0;
    for (const glm::vec3 position : surface.mesh.positions[0]) {
        const glm::vec2 pixel = pixel_of(camera, plain, position);
        const auto x = static_cast<int>(pixel.x);
        const auto y = static_cast<int>(pixel.y);
        seen += dots.light(x, y) != plain.light(x, y) ? 1 : 0;
    }
    CHECK(seen > static_cast<int>(surface.mesh.vertex_count()) / 3);
}
