// Tests of contexts, targets and handles.
#include "render/context.h"

#include <cstdlib>
#include <optional>

#include <doctest/doctest.h>
#include <glad/gl.h>
#include <glm/geometric.hpp>

#include "hierarchy/error.h"
#include "render/picture.h"
#include "render/test_surfaces.h"

using namespace interleaf;

namespace {

/// Number of live buffers, textures, framebuffers, renderbuffers, vertex arrays and programs.
int live_objects() {
    int count = 0;
    for (GLuint name = 1; name < 500; ++name)
        count += glIsBuffer(name) + glIsTexture(name) + glIsFramebuffer(name) + glIsRenderbuffer(name) +
                 glIsVertexArray(name) + glIsProgram(name);
    return count;
}

}  // namespace

TEST_CASE("OpenGL 3.3 core contexts can be made without a display, again and again") {
    for (int i = 0; i < 3; ++i) {
        EglContext first;
        const EglContext context = std::move(first);
        GLint major = 0;
        GLint minor = 0;
        GLint profile = 0;
        glGetIntegerv(GL_MAJOR_VERSION, &major);
        glGetIntegerv(GL_MINOR_VERSION, &minor);
        glGetIntegerv(GL_CONTEXT_PROFILE_MASK, &profile);
        CHECK(10 * major + minor >= 33);
        CHECK((profile & GL_CONTEXT_CORE_PROFILE_BIT) != 0);
    }
}

TEST_CASE("a window without a display is reported as the machine's fault") {
    const char* display = std::getenv("DISPLAY");
    const std::optional<std::string> before =
        display != nullptr ? std::optional<std::string>(display) : std::nullopt;
    unsetenv("DISPLAY");
    CHECK_THROWS_AS(Window("interleaf", 100, 100, false), MachineError);
    if (before) setenv("DISPLAY", before->c_str(), 1);
}

TEST_CASE("mistakes in the use of OpenGL are collected, once") {
    const EglContext context;
    take_debug_messages();
    glEnable(0xdead);
    CHECK(glGetError() == GL_INVALID_ENUM);
    CHECK(take_debug_messages().size() == 1);
    CHECK(take_debug_messages().empty());
}

TEST_CASE("a renderer and a target release their objects") {
    const EglContext context;
    const int before = live_objects();
    {
        const TestSurface surface = surface_of_shapes({"sphere", "star"}, 200);
        Renderer renderer;
        OffscreenTarget target(64, 64, 4);
        renderer.upload(surface.mesh, surface.form);
        Display display;
        display.wireframe = true;
        const float weights[] = {0.5F, 0.5F};
        take_picture(renderer, target, camera_on(surface, target), weights, display);
        CHECK(live_objects() > before + 10);
        Renderer moved = std::move(renderer);
        take_picture(moved, target, camera_on(surface, target), weights, display);
    }
    CHECK(live_objects() == before);
}

TEST_CASE("a target that the machine cannot draw into is rejected") {
    const EglContext context;
    CHECK_THROWS_AS(OffscreenTarget(1 << 20, 16, 1), MachineError);
    CHECK_THROWS_AS(OffscreenTarget(16, 16, 1000), MachineError);
}

TEST_CASE("a picture is read with its top row first and sRGB-encoded") {
    const EglContext context;
    for (const int samples : {1, 4}) {
        OffscreenTarget target(5, 4, samples);
        target.bind();
        glEnable(GL_FRAMEBUFFER_SRGB);
        glClearColor(0.5F, 0, 0, 1);
        glClear(GL_COLOR_BUFFER_BIT);
        glEnable(GL_SCISSOR_TEST);
        glScissor(0, 3, 5, 1);  // the top row: OpenGL counts from below
        glClearColor(0, 0, 1, 1);
        glClear(GL_COLOR_BUFFER_BIT);
        const Picture picture{5, 4, target.read_rgba()};
        CHECK(picture.rgba[2] == 255);
        CHECK(picture.rgba[0] == 0);
        CHECK(picture.rgba[20] == 188);  // half the light, encoded
        CHECK(picture.rgba.back() == 255);
    }
}

TEST_CASE("the depth under a pixel gives the surface point there") {
    const EglContext context;
    const TestSurface surface = surface_of_shapes({"sphere"}, 8000);
    Renderer renderer;
    renderer.upload(surface.mesh, surface.form);
    for (const int samples : {1, 4}) {
        OffscreenTarget target(300, 200, samples);
        const Camera camera = camera_on(surface, target);
        const float weights[] = {1};
        take_picture(renderer, target, camera, weights);
        const int x = 130;
        const int y = 60;
        const glm::vec2 pointer(2 * (x + 0.5F) / 300 - 1, 1 - 2 * (y + 0.5F) / 200);
        const glm::vec3 point = camera.point_at(pointer, target.depth_at(x, y), 1.5F);
        CHECK(glm::length(point) == doctest::Approx(1).epsilon(0.01));
        CHECK(target.depth_at(0, 0) == 1);
    }
}
