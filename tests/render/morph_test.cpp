// Tests of the morph in the vertex shader against the morph on the processor, and of the effect of weights.
#include "hierarchy/morph.h"

#include <vector>

#include <doctest/doctest.h>
#include <glad/gl.h>

#include "render/context.h"
#include "render/picture.h"
#include "render/test_surfaces.h"
#include "shapes/shapes.h"

using namespace interleaf;

namespace {

TestSurface repeated(const std::vector<Hierarchy>& keys, std::size_t count) {
    std::vector<Hierarchy> all;
    all.reserve(count);
    for (std::size_t i = 0; i < count; ++i) all.push_back(keys[i % keys.size()]);
    return surface_of(all);
}

/// \p weights distributed over the repeated keys.
std::vector<float> repeated(const std::vector<float>& weights, std::size_t count) {
    std::vector<float> all(count);
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t times = (count - i % weights.size() + weights.size() - 1) / weights.size();
        all[i] = weights[i % weights.size()] / static_cast<float>(times);
    }
    return all;
}

std::vector<Hierarchy> keys_of(std::initializer_list<std::string_view> names) {
    std::vector<Hierarchy> keys;
    ShapeBudget budget;
    budget.leaves = 3000;
    for (const std::string_view name : names) keys.push_back(make_key(*find_shape(name), budget));
    return keys;
}

}  // namespace

TEST_CASE("the picture is the same for one to four keys on the GPU and for more keys on the processor") {
    const EglContext context;
    const std::vector<Hierarchy> keys = keys_of({"star", "bone"});
    const std::vector<float> weights = {0.7F, 0.3F};
    OffscreenTarget target(640, 480, 1);
    Renderer renderer;
    const TestSurface two = repeated(keys, 2);
    const Camera camera = camera_on(two, target);
    renderer.upload(two.mesh, two.form);
    const Picture expected = take_picture(renderer, target, camera, weights);
    for (const std::size_t count : {3U, 4U, 5U, 6U}) {
        CAPTURE(count);
        const TestSurface surface = repeated(keys, count);
        renderer.upload(surface.mesh, surface.form);
        const Picture picture = take_picture(renderer, target, camera, repeated(weights, count));
        // The processor takes the normals of the blended surface, which differ a little.
        const bool is_exact = count <= max_gpu_keys;
        CHECK(count_differences(picture, expected, is_exact ? 2 : 12) < (is_exact ? 60 : 300));
    }
    // One key: the morph itself, uploaded.
    const TestSurface morphed = surface_of({morphed_hierarchy(two.mesh, weights)});
    renderer.upload(morphed.mesh, morphed.form);
    const float one[] = {1};
    const Picture picture = take_picture(renderer, target, camera, one);
    CHECK(count_differences(picture, expected, 40) < 0.01 * 640 * 480);
}

TEST_CASE("the blend on the processor follows the weights") {
    const EglContext context;
    const std::vector<Hierarchy> keys = keys_of({"star", "bone", "cushion", "sphere", "icosahedron"});
    const TestSurface five = surface_of(keys);
    Renderer renderer;
    renderer.upload(five.mesh, five.form);
    OffscreenTarget target(320, 240, 1);
    const Camera camera = camera_on(five, target);
    const std::vector<float> star = {1, 0, 0, 0, 0};
    const std::vector<float> sphere = {0, 0, 0, 1, 0};
    const Picture first = take_picture(renderer, target, camera, star);
    CHECK(count_differences(take_picture(renderer, target, camera, sphere), first, 8) > 3000);
    CHECK(take_picture(renderer, target, camera, star) == first);
}

TEST_CASE("keys that turn are drawn as their turning blend, and as themselves at weight 1") {
    const EglContext context;
    TestSurface straight = surface_of(keys_of({"star", "bone"}));
    UnionMesh turning = straight.mesh;
    turning.turning.emplace(turning);
    Renderer renderer;
    OffscreenTarget target(320, 240, 1);
    const Camera camera = camera_on(straight, target);
    const std::vector<float> half = {0.5F, 0.5F};
    const std::vector<float> star = {1, 0};
    renderer.upload(straight.mesh, straight.form);
    const Picture straight_half = take_picture(renderer, target, camera, half);
    const Picture straight_star = take_picture(renderer, target, camera, star);
    renderer.upload(turning, {});
    const Picture picture = take_picture(renderer, target, camera, half);
    CHECK(count_differences(picture, straight_half, 40) > 1000);
    // The processor takes the normals of the blended surface, which differ a little.
    CHECK(count_differences(take_picture(renderer, target, camera, star), straight_star, 12) < 300);

    straight.mesh.positions = {morph(turning, half)};
    Buffer<glm::vec3> normals;
    surface_normals(turning, half, straight.mesh.positions[0], normals);
    renderer.upload_blend(turning, straight.mesh.positions[0], normals, std::vector<std::size_t>{0, 1});
    const std::vector<float> one = {1};
    CHECK(count_differences(take_picture(renderer, target, camera, one), picture, 2) < 60);
}

TEST_CASE("the picture of a blend that the caller has made is that of the keys") {
    const EglContext context;
    const TestSurface surface = surface_of(keys_of({"star", "bone"}));
    const std::vector<float> weights = {0.6F, 0.4F};
    OffscreenTarget target(320, 240, 1);
    Renderer renderer;
    renderer.upload(surface.mesh, surface.form);
    const Camera camera = camera_on(surface, target);
    const Picture expected = take_picture(renderer, target, camera, weights);
    const Buffer<glm::vec3> positions = morph(surface.mesh, weights);
    const std::vector<glm::vec3> normals = morph_normals(surface.form, weights);
    const std::vector<std::size_t> family_keys = {0, 1};
    renderer.upload_blend(surface.mesh, positions, normals, family_keys);
    const std::vector<float> one = {1};
    CHECK(count_differences(take_picture(renderer, target, camera, one), expected, 2) < 30);
    Display by_origin;
    by_origin.coloring = Coloring::origin;
    const Picture colored = take_picture(renderer, target, camera, one, by_origin);
    renderer.upload(surface.mesh, surface.form);
    CHECK(count_differences(take_picture(renderer, target, camera, weights, by_origin), colored, 2) < 30);
}

TEST_CASE("changing only the weights changes the picture, and restoring them restores it") {
    const EglContext context;
    const TestSurface surface = surface_of(keys_of({"star", "sphere"}));
    Renderer renderer;
    renderer.upload(surface.mesh, surface.form);
    OffscreenTarget target(320, 240, 4);
    const Camera camera = camera_on(surface, target);
    const float star[] = {1, 0};
    const float half[] = {0.5F, 0.5F};
    const float beyond[] = {1.5F, -0.5F};
    const Picture at_star = take_picture(renderer, target, camera, star);
    const Picture at_half = take_picture(renderer, target, camera, half);
    CHECK(count_differences(at_half, at_star, 8) > 3000);
    CHECK(count_differences(take_picture(renderer, target, camera, beyond), at_star, 8) > 3000);
    CHECK(take_picture(renderer, target, camera, star) == at_star);
}

TEST_CASE("weight 1 on a key shows that key, no matter which other key refines the union") {
    const EglContext context;
    const std::vector<Hierarchy> keys = keys_of({"star", "bone", "cushion"});
    const TestSurface all = surface_of(keys);
    OffscreenTarget target(640, 480, 1);
    const Camera camera = camera_on(all, target);
    Renderer renderer;
    for (std::size_t key = 0; key < keys.size(); ++key) {
        CAPTURE(key);
        std::vector<float> weights(keys.size(), 0);
        weights[key] = 1;
        renderer.upload(all.mesh, all.form);
        const Picture of_union = take_picture(renderer, target, camera, weights);
        const TestSurface alone = surface_of({keys[key]});
        renderer.upload(alone.mesh, alone.form);
        const float one[] = {1};
        const Picture of_key = take_picture(renderer, target, camera, one);
        CHECK(count_differences(of_union, of_key, 40) < 0.002 * 640 * 480);
    }
}

TEST_CASE("after a larger surface, a smaller one leaves nothing of it behind") {
    const EglContext context;
    const TestSurface large = surface_of(keys_of({"star", "bone", "cushion", "sphere"}));
    const TestSurface small = surface_of(keys_of({"icosahedron"}));
    OffscreenTarget target(320, 240, 1);
    const Camera camera = camera_on(small, target);
    const float one[] = {1};
    const float four[] = {0.25F, 0.25F, 0.25F, 0.25F};
    Renderer fresh;
    fresh.upload(small.mesh, small.form);
    const Picture expected = take_picture(fresh, target, camera, one);
    Renderer used;
    used.upload(large.mesh, large.form);
    take_picture(used, target, camera, four);
    used.upload(small.mesh, small.form);
    CHECK(take_picture(used, target, camera, one) == expected);
}
