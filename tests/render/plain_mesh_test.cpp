// Tests of meshes that are no keys, drawn as they are, and of the depths that tell where they are in a
// picture.
#include "render/plain_mesh.h"

#include <doctest/doctest.h>

#include "render/context.h"
#include "render/picture.h"
#include "render/test_surfaces.h"

using namespace interleaf;

TEST_CASE("a plain mesh with flat shading looks like the key with the same leaves") {
    const EglContext context;
    const TestSurface key = surface_of_shapes({"star"}, 2000);
    const UnionMesh plain = plain_mesh(key.mesh.triangles, key.mesh.positions.front());
    CHECK(plain.leaf_count() == key.mesh.leaf_count());
    CHECK(plain.vertex_count() == key.mesh.vertex_count());
    OffscreenTarget target(200, 150, 1);
    Renderer renderer;
    const Camera camera = camera_on(key, target);
    Display flat;
    flat.shading = Shading::flat;
    flat.wireframe = true;
    renderer.upload(key.mesh, key.form);
    const Picture of_key = take_picture(renderer, target, camera, one, flat);
    renderer.upload(plain, normal_form(plain));
    CHECK(take_picture(renderer, target, camera, one, flat) == of_key);
}

TEST_CASE("unordered, open and intersecting triangles are drawn too") {
    const EglContext context;
    const std::vector<glm::vec3> positions{{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, -1}};
    const std::vector<Triangle> triangles{{0, 1, 2}, {0, 1, 2}, {2, 1, 0}, {0, 1, 3}, {0, 1, 4}};
    const UnionMesh mesh = plain_mesh(triangles, positions);
    OffscreenTarget target(100, 100, 1);
    Renderer renderer;
    const Picture empty = take_picture(renderer, target, Camera(), {});
    renderer.upload(mesh, normal_form(mesh));
    Display display;
    display.root_edges = true;
    const Picture picture = take_picture(renderer, target, Camera(), one);
    CHECK(count_differences(picture, empty) > 1000);
    // None of its edges is a root edge.
    CHECK(take_picture(renderer, target, Camera(), one, display) == picture);
}

TEST_CASE("the depths of a target are those of its pixels, top row first") {
    const EglContext context;
    const TestSurface key = surface_of_shapes({"star"}, 500);
    Renderer renderer;
    renderer.upload(key.mesh, key.form);
    OffscreenTarget target(61, 37, 1);
    take_picture(renderer, target, camera_on(key, target), one);
    const std::vector<float> depths = target.read_depths();
    REQUIRE(depths.size() == 61 * 37);
    int covered = 0;
    for (int y = 0; y < 37; ++y)
        for (int x = 0; x < 61; ++x) {
            const float depth = depths[static_cast<std::size_t>(61 * y + x)];
            CHECK(depth == target.depth_at(x, y));
            covered += depth < 1 ? 1 : 0;
        }
    CHECK(covered > 200);
}
