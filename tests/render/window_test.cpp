// Tests of the window against EGL: one renderer, one picture. Needs a display.
#include <doctest/doctest.h>
#include <glad/gl.h>

#include "render/context.h"
#include "render/picture.h"
#include "render/test_surfaces.h"

using namespace interleaf;

namespace {

constexpr int width = 320;
constexpr int height = 240;

/// A picture with every kind of content, in the current context.
Picture full_picture(OffscreenTarget& target) {
    const TestSurface surface = surface_of_shapes({"star", "bone", "sphere"}, 3000);
    Renderer renderer;
    renderer.upload(surface.mesh, surface.form);
    Display display;
    display.coloring = Coloring::origin;
    display.wireframe = display.refinement_edges = display.root_edges = true;
    const float weights[] = {0.5F, 0.25F, 0.25F};
    return take_picture(renderer, target, camera_on(surface, target), weights, display);
}

}  // namespace

TEST_CASE("a hidden window draws the picture that EGL draws, byte for byte") {
    for (const int samples : {1, 4}) {
        Picture without_display;
        {
            const EglContext context;
            OffscreenTarget target(width, height, samples);
            without_display = full_picture(target);
        }
        const Window window("interleaf", width, height, false);
        OffscreenTarget target(width, height, samples);
        const Picture picture = full_picture(target);
        CHECK(count_pixels(picture, is_white) > 100);  // root edges
        CHECK(count_differences(picture, without_display) == 0);
    }
}

TEST_CASE("the window receives the encoded values unchanged, at the requested place") {
    const Window window("interleaf", width + 20, height + 30, true);
    glClearColor(0, 0, 0, 1);
    for (const int samples : {1, 4}) {
        OffscreenTarget target(width, height, samples);
        const Picture drawn = full_picture(target);
        glBindFramebuffer(GL_FRAMEBUFFER, 0);
        glClear(GL_COLOR_BUFFER_BIT);
        target.blit_to_window(12, 7);

        Picture received{width, height, std::vector<std::uint8_t>(drawn.rgba.size())};
        glReadBuffer(GL_BACK);
        std::uint8_t* row = received.rgba.data();
        for (int y = 0; y < height; ++y, row += std::ptrdiff_t{4} * width)
            glReadPixels(12, 7 + height - 1 - y, width, 1, GL_RGBA, GL_UNSIGNED_BYTE, row);
        CHECK(count_differences(received, drawn) == 0);
        std::uint8_t outside[4] = {1, 1, 1, 1};
        glReadPixels(5, 3, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, outside);
        CHECK(outside[0] == 0);
        CHECK(glGetError() == GL_NO_ERROR);
        CHECK(take_debug_messages().empty());
    }
}
