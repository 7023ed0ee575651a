// Tests of ambient occlusion.
#include "render/occlusion.h"

#include <doctest/doctest.h>

#include "render/context.h"
#include "render/picture.h"
#include "render/test_surfaces.h"

namespace interleaf {
namespace {

/// A picture of \p surface, and the same with hollows darkened by \p strength.
struct Darkened {
    Picture before;
    Picture after;

    Darkened(const TestSurface& surface, int samples, float strength) {
        Renderer renderer;
        renderer.upload(surface.mesh, surface.form);
        OffscreenTarget target(301, 200, samples);
        const Camera camera = camera_on(surface, target);
        before = take_picture(renderer, target, camera, one);
        Occlusion occlusion;
        occlusion.darken(target, camera, strength);
        after = {target.width(), target.height(), target.read_rgba()};
    }
};

TEST_CASE("occlusion darkens the hollows of a star; a sphere has none") {
    const EglContext context;
    const TestSurface star = surface_of_shapes({"star"}, 5000);
    const TestSurface sphere = surface_of_shapes({"sphere"}, 20000);
    for (const int samples : {1, 4}) {
        CAPTURE(samples);
        const Darkened hollow(star, samples, 1);
        CHECK(mean_brightness(hollow.after) < 0.98 * mean_brightness(hollow.before));
        CHECK(count_differences(hollow.before, hollow.after, 30) > 300);
        int brighter = 0;
        for (std::size_t i = 0; i < hollow.after.rgba.size(); ++i)
            brighter += static_cast<int>(hollow.after.rgba[i] > hollow.before.rgba[i]);
        CHECK(brighter == 0);

        const Darkened round(sphere, samples, 1);
        CHECK(count_differences(round.before, round.after, 12) < 100);
    }
}

TEST_CASE("occlusion leaves the background, and at strength 0 the whole picture") {
    const EglContext context;
    const TestSurface star = surface_of_shapes({"star"}, 5000);
    const Darkened darkened(star, 1, 1);
    for (int x = 0; x < darkened.before.width; ++x)
        CHECK(darkened.before.light(x, 0) == darkened.after.light(x, 0));
    const Darkened same(star, 4, 0);
    CHECK(same.before == same.after);
}

}  // namespace
}  // namespace interleaf
