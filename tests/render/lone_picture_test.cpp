// A mesh drawn by itself is drawn as step by step.
#include "render/lone_picture.h"

#include <doctest/doctest.h>

#include "render/context.h"
#include "render/picture.h"
#include "render/test_surfaces.h"

using namespace interleaf;

TEST_CASE("a lone picture is the same as uploading and drawing the mesh, whatever was drawn before") {
    const EglContext context;
    const TestSurface star = surface_of_shapes({"star"}, 500);
    const TestSurface bone = surface_of_shapes({"bone"}, 500);
    OffscreenTarget target(90, 60, 4);
    Display display;
    display.wireframe = true;
    const Camera camera = camera_on(star, target);
    Renderer renderer;
    renderer.upload(star.mesh, star.form);
    const Picture expected = take_picture(renderer, target, camera, one, display);

    Renderer other;
    const LonePicture first{.size = {30, 30}, .samples = 1, .camera = camera_on(bone, target), .display = {}};
    CHECK(texture_alone(other, bone.mesh, bone.form, first).name() != 0);
    const LonePicture second{.size = {90, 60}, .camera = camera, .display = display};
    OffscreenTarget drawn = draw_alone(other, star.mesh, star.form, second);
    CHECK(Picture{90, 60, drawn.read_rgba()} == expected);
}
