// Tests of the surface in the window: where a union takes long, the last surface stays and no call waits
// for it.
#include "app/pictures/morph_surface.h"

#include <chrono>
#include <thread>
#include <utility>
#include <vector>

#include <doctest/doctest.h>

#include "app/pictures/held_unions.h"
#include "render/context.h"
#include "shapes/shapes.h"

using namespace interleaf;
using namespace interleaf::testing;

namespace {

Family family_of(Index leaves) {
    Family family;
    family.name = "slow";
    for (const char* const name : {"star", "sphere", "bone"})
        family.keys.push_back(
            {name, SharedHierarchy(make_key(*find_shape(name), {.leaves = leaves, .tolerance = {}}))});
    return family;
}

}  // namespace

TEST_CASE("while a union is made, the last surface stays with its weights, and no update waits for it") {
    const EglContext context;
    const Family family = family_of(400);
    MorphSurface surface(union_when_released);
    surface.update(family, {{0, 0.5}, {1, 0.5}}, nullptr);
    REQUIRE(surface.figures().rebuilds == 1);  // the first surface is waited for
    CHECK_FALSE(surface.figures().is_late);

    const Weights next{{1, 0.25}, {2, 0.75}};
    unions_are_held = true;
    for (int frame = 0; frame < 3; ++frame) {
        surface.update(family, next, nullptr);
        CHECK(surface.figures().is_late);
        CHECK(surface.weights() == std::vector<float>{0.5F, 0.5F});
        CHECK(surface.figures().keys == std::vector<std::size_t>{0, 1});
    }
    unions_are_held = false;
    int late = 0;
    for (surface.update(family, next, nullptr); surface.figures().is_late;
         surface.update(family, next, nullptr))
        REQUIRE(++late < 10'000);
    CHECK(surface.weights() == std::vector<float>{0.25F, 0.75F});
    CHECK(surface.figures().keys == std::vector<std::size_t>{1, 2});
    CHECK(surface.figures().rebuilds == 2);
    CHECK(surface.figures().waits == 2);
}

TEST_CASE("going back while a union is made shows the present union at once") {
    const EglContext context;
    const Family family = family_of(400);
    MorphSurface surface(union_when_released);
    const Weights first{{0, 0.5}, {1, 0.5}};
    surface.update(family, first, nullptr);
    unions_are_held = true;
    surface.update(family, {{1, 0.5}, {2, 0.5}}, nullptr);
    CHECK(surface.figures().is_late);
    surface.update(family, first, nullptr);
    unions_are_held = false;
    CHECK_FALSE(surface.figures().is_late);
    CHECK(surface.figures().rebuilds == 1);
}

TEST_CASE("a family whose parts turn is drawn turning, and straight again when it says so") {
    const EglContext context;
    Family family = family_of(400);
    const Weights weights{{0, 0.5}, {1, 0.5}};
    MorphSurface surface;
    const auto settle = [&] {
        for (int frame = 0; frame < 1000; ++frame) {
            surface.update(family, weights, nullptr);
            if (!surface.figures().is_late) return;
            std::this_thread::sleep_for(std::chrono::milliseconds(2));
        }
    };
    settle();
    const Extent straight = surface.extent();
    CHECK_FALSE(surface.mesh().turning);
    family.blend = BlendKind::turning;
    settle();
    CHECK(surface.mesh().turning);
    CHECK(surface.extent().box != straight.box);
    surface.update(family, {{0, 1}, {1, 0}}, nullptr);
    CHECK(surface.figures().rebuilds == 2);
    family.blend = BlendKind::straight;
    settle();
    CHECK_FALSE(surface.mesh().turning);
    CHECK(surface.extent().box == straight.box);
}

TEST_CASE("parts begin to turn, and stop turning, without waiting for a union that is made") {
    const EglContext context;
    Family family = family_of(400);
    const Weights weights{{0, 0.5}, {1, 0.5}};
    MorphSurface surface(union_when_released);
    surface.update(family, weights, nullptr);
    unions_are_held = true;
    family.blend = BlendKind::turning;
    surface.update(family, weights, nullptr);
    CHECK(surface.figures().is_late);
    const auto begin = std::chrono::steady_clock::now();
    family.blend = BlendKind::straight;
    surface.update(family, weights, nullptr);
    CHECK(std::chrono::steady_clock::now() - begin < std::chrono::seconds(5));
    CHECK_FALSE(surface.figures().is_late);
    CHECK(surface.figures().rebuilds == 1);

    unions_are_held = false;
    family.blend = BlendKind::turning;
    int late = 0;
    for (surface.update(family, weights, nullptr); surface.figures().is_late;
         surface.update(family, weights, nullptr))
        REQUIRE(++late < 10'000);
    CHECK(surface.mesh().turning);
    family.blend = BlendKind::straight;
    surface.update(family, weights, nullptr);
    CHECK_FALSE(surface.figures().is_late);  // the straight union is still there
    CHECK_FALSE(surface.mesh().turning);
}

TEST_CASE("a large union is sent in slices, ahead of its need or while the last surface stays") {
    const EglContext context;
    const Family family = family_of(120'000);
    const Weights first{{0, 0.5}, {1, 0.5}};
    const Weights next{{1, 0.5}, {2, 0.5}};
    const std::vector<std::vector<std::size_t>> expected{{1, 2}};
    for (const bool is_ahead : {false, true}) {
        CAPTURE(is_ahead);
        MorphSurface surface;
        surface.update(family, first, nullptr);
        surface.expect(family, expected);
        // Once the union is made, each frame sends a slice of it, and there are several slices.
        const auto has_sent_all = [&] { return surface.renderer().send(0); };
        int frames = 0;
        const auto draw_frame = [&] {
            surface.update(family, first, nullptr);
            surface.expect(family, expected);
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
            REQUIRE(++frames < 60'000);
        };
        while (is_ahead && has_sent_all()) draw_frame();
        while (is_ahead && !has_sent_all()) draw_frame();
        int late = 0;
        for (surface.update(family, next, nullptr); surface.figures().is_late && late < 1000; ++late)
            surface.update(family, next, nullptr);
        CHECK(surface.figures().rebuilds == 2);
        CHECK(surface.figures().keys == std::vector<std::size_t>{1, 2});
        if (is_ahead) CHECK(late == 0);
        if (!is_ahead) CHECK(late > 0);
    }
}
