// Tests of edges: which ones are drawn, in which order, and with which width.
#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "render/context.h"
#include "render/picture.h"
#include "render/test_surfaces.h"

using namespace interleaf;

namespace {

Display showing(bool wireframe, bool refinement_edges, bool root_edges) {
    Display display;
    display.wireframe = wireframe;
    display.refinement_edges = refinement_edges;
    display.root_edges = root_edges;
    return display;
}

/// Width in pixels of the red line that crosses the middle row at 45 degrees, computed from the red that it
/// adds to \p plain.
float red_width(const Picture& picture, const Picture& plain) {
    float sum = 0;
    const int row = picture.height / 2;
    for (int x = 0; x < picture.width; ++x) {
        const float before = plain.light(x, row).g;
        sum +=
            (before - picture.light(x, row).g) / (before - 0.10F);  // 0.10 is the green of refinement edges
    }
    return sum / std::sqrt(2.0F);
}

}  // namespace

TEST_CASE("each kind of edge shows in its own color, and only if it is enabled") {
    const EglContext context;
    const TestSurface sphere = surface_of_shapes({"sphere"}, 600);
    Renderer renderer;
    renderer.upload(sphere.mesh, sphere.form);
    OffscreenTarget target(640, 480, 4);
    const Camera camera = camera_on(sphere, target);
    const Picture plain = take_picture(renderer, target, camera, one);
    const Picture wire = take_picture(renderer, target, camera, one, showing(true, false, false));
    const Picture refinement = take_picture(renderer, target, camera, one, showing(false, true, false));
    const Picture roots = take_picture(renderer, target, camera, one, showing(false, false, true));

    CHECK(count_pixels(plain, is_red) == 0);
    CHECK(count_pixels(plain, is_white) == 0);
    CHECK(count_pixels(wire, is_red) == 0);
    CHECK(count_pixels(wire, is_white) == 0);
    CHECK(count_differences(wire, plain, 8) > 5000);
    CHECK(mean_brightness(wire) < 0.95 * mean_brightness(plain));
    CHECK(count_pixels(refinement, is_red) > 2000);
    CHECK(count_pixels(refinement, is_white) == 0);
    CHECK(count_pixels(roots, is_white) > 400);
    CHECK(count_pixels(roots, is_red) == 0);
    // There are more leaf edges than refinement edges, and more refinement edges than root edges.
    CHECK(count_differences(wire, plain, 8) > count_differences(refinement, plain, 8));
    CHECK(count_differences(refinement, plain, 8) > count_differences(roots, plain, 8));
}

TEST_CASE("root edges are drawn above refinement edges, and these above leaf edges") {
    const EglContext context;
    const TestSurface icosahedron = surface_of_shapes({"icosahedron"}, 20);
    Renderer renderer;
    renderer.upload(icosahedron.mesh, icosahedron.form);
    OffscreenTarget target(640, 480, 1);
    const Camera camera = camera_on(icosahedron, target);
    const Picture refinement = take_picture(renderer, target, camera, one, showing(false, true, false));
    const Picture without_roots = take_picture(renderer, target, camera, one, showing(true, true, false));
    const Picture all = take_picture(renderer, target, camera, one, showing(true, true, true));
    CHECK(count_pixels(refinement, is_red) > 300);
    CHECK(count_pixels(without_roots, is_red) > 0.85 * count_pixels(refinement, is_red));
    // Every edge of the unrefined icosahedron is a root edge.
    CHECK(count_pixels(all, is_red) == 0);
    CHECK(count_pixels(all, is_white) > 300);
}

TEST_CASE("the refinement edge is the one opposite the first vertex") {
    const EglContext context;
    TestSurface square = surface_of({two_keys_of_a_square().back()});
    OffscreenTarget target(400, 400, 1);
    const Camera camera = camera_on(square, target, 0, 0);
    Renderer renderer;
    renderer.upload(square.mesh, square.form);
    const Picture picture = take_picture(renderer, target, camera, one, showing(false, true, false));
    const auto on_diagonal = [&](glm::vec3 point) {
        const glm::ivec2 at(pixel_of(camera, picture, point));
        return is_red(picture.light(at.x, at.y));
    };
    for (float t = -0.9F; t < 1; t += 0.1F) CHECK(on_diagonal({t, t, 0}));
    CHECK_FALSE(on_diagonal({0.5F, -0.5F, 0}));
    for (float t = -0.9F; t < 1; t += 0.1F) CHECK_FALSE(on_diagonal({t, -0.995F, 0}));
}

TEST_CASE("a line has the requested width, near and far") {
    const EglContext context;
    const TestSurface square = surface_of({two_keys_of_a_square().back()});
    Renderer renderer;
    renderer.upload(square.mesh, square.form);
    OffscreenTarget target(600, 600, 1);
    Display display = showing(false, true, false);
    for (const float width : {1.5F, 3.0F, 6.0F})
        for (const float zoom : {0.25F, 1.0F, 4.0F, 40.0F}) {
            CAPTURE(width);
            CAPTURE(zoom);
            Camera camera = camera_on(square, target, 0, 0);
            camera.zoom(zoom, {0, 0}, 1);
            display.line_width = width;
            const Picture plain = take_picture(renderer, target, camera, one);
            const Picture picture = take_picture(renderer, target, camera, one, display);
            CHECK(red_width(picture, plain) == doctest::Approx(width).epsilon(0.1));
        }
}

TEST_CASE("a line is complete if its triangle extends behind the viewer") {
    const EglContext context;
    const TestSurface square = surface_of({two_keys_of_a_square().back()});
    Renderer renderer;
    renderer.upload(square.mesh, square.form);
    OffscreenTarget target(600, 600, 1);
    // Close above the square's center at a grazing angle: a corner of both triangles is behind the camera.
    Camera camera;
    camera.look_from(-45, 4);
    camera.view_all(extent_of({glm::vec3(-1, -1, 0), glm::vec3(1, 1, 0)}), 1);
    camera.look_from(80, 0);
    camera.approach(30, glm::vec3(0));
    const Picture picture = take_picture(renderer, target, camera, one, showing(false, true, false));
    CHECK(is_red(picture.light(300, 300)));
    CHECK(count_pixels(picture, is_red) < 600 * 8);
    CHECK(count_pixels(picture, is_red) > 600 / 2);
}

TEST_CASE("on a mesh of tiny triangles the lines fade and the shape stays visible") {
    const EglContext context;
    const TestSurface sphere = surface_of_shapes({"sphere"}, 60000);
    Renderer renderer;
    renderer.upload(sphere.mesh, sphere.form);
    OffscreenTarget target(200, 150, 4);
    const Camera camera = camera_on(sphere, target);
    const Picture plain = take_picture(renderer, target, camera, one);
    const Picture wire = take_picture(renderer, target, camera, one, showing(true, false, false));
    CHECK(mean_brightness(wire) < mean_brightness(plain));
    CHECK(mean_brightness(wire) > 0.75 * mean_brightness(plain));
}

TEST_CASE("root edges have no gaps across small triangles") {
    const EglContext context;
    const TestSurface sphere = surface_of_shapes({"sphere"}, 20000);
    Renderer renderer;
    renderer.upload(sphere.mesh, sphere.form);
    OffscreenTarget target(320, 240, 4);
    const Camera camera = camera_on(sphere, target);
    Display display = showing(false, false, true);
    display.line_width = 3;
    const Picture picture = take_picture(renderer, target, camera, one, display);
    const UnionMesh& mesh = sphere.mesh;
    int seen = 0;
    for (std::size_t leaf = 0; leaf < mesh.leaf_count(); ++leaf)
        for (unsigned corner = 0; corner < 3; ++corner) {
            if (!mesh.tags[leaf].on_root_edge(corner)) continue;
            const auto& positions = mesh.positions.front();
            const glm::vec3 a = positions[mesh.triangles[leaf][(corner + 1) % 3]];
            const glm::vec3 b = positions[mesh.triangles[leaf][(corner + 2) % 3]];
            if (glm::dot(glm::normalize(camera.eye()), a) < 0.6F) continue;  // turned away
            for (const glm::vec3 point : {a, (a + b) / 2.0F}) {
                const glm::ivec2 at(pixel_of(camera, picture, point));
                CHECK(glm::dot(picture.light(at.x, at.y), glm::vec3(1)) > 2);
                ++seen;
            }
        }
    CHECK(seen > 200);
}
