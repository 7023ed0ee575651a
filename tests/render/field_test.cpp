// Tests of pictures of fields, and of the checkerboard over the roots.
#include <cmath>

#include <doctest/doctest.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "hierarchy/leaf_path.h"
#include "hierarchy/level_map.h"
#include "hierarchy/morph.h"
#include "hierarchy/union_fields.h"
#include "render/context.h"
#include "render/pick.h"
#include "render/picture.h"
#include "render/test_surfaces.h"
#include "shapes/shapes.h"

using namespace interleaf;

namespace {

/// The keys of a square with different bisections, each with its own scalar field "f" and color field "c".
std::vector<Hierarchy> keys_with_fields() {
    std::vector<Hierarchy> keys = two_keys_of_a_square();
    for (std::size_t key = 0; key < keys.size(); ++key) {
        Field scalar{"f", FieldKind::scalar, {}};
        Field color{"c", FieldKind::color, {}};
        for (const glm::vec3& p : keys[key].positions) {
            scalar.values.push_back(key == 0 ? p.x * p.x - 0.3F * p.y : 2 * p.y);
            const glm::vec3 mixed = 0.5F + 0.5F * (key == 0 ? p : glm::vec3(p.y, p.x, p.x * p.y));
            color.values.insert(color.values.end(), {mixed.r, mixed.g, mixed.b});
        }
        keys[key].fields = {scalar, color};
    }
    return keys;
}

TestSurface surface_with_fields(const std::vector<Hierarchy>& keys) {
    TestSurface surface = surface_of(keys);
    std::vector<const Hierarchy*> pointers;
    for (const Hierarchy& key : keys) pointers.push_back(&key);
    unite_fields(pointers, surface.mesh);
    return surface;
}

glm::vec3 middle(const UnionMesh& mesh, std::span<const float> weights, std::size_t leaf) {
    const Buffer<glm::vec3> positions = morph(mesh, weights);
    const auto& [a, b, c] = mesh.triangles[leaf];
    return (positions[a] + positions[b] + positions[c]) / 3.0F;
}

/// The blended values of \p field in the middle of a leaf.
std::vector<float> field_in_middle(const UnionMesh& mesh, std::size_t field, std::span<const float> weights,
                                   std::size_t leaf) {
    Buffer<float> values;
    morph(mesh.fields[field], weights, values);
    const std::size_t width = component_count(mesh.fields[field].label.kind);
    std::vector<float> result(width, 0);
    for (const Index vertex : mesh.triangles[leaf])
        for (std::size_t c = 0; c < width; ++c) result[c] += values[width * vertex + c] / 3;
    return result;
}

/// Checks that the middle of each leaf has the linear light color_of(leaf) times the incident light.
void check_leaves(const UnionMesh& mesh, std::span<const float> weights, const Camera& camera,
                  const Picture& plain, const Picture& picture,
                  const std::function<glm::vec3(std::size_t)>& color_of) {
    for (std::size_t leaf = 0; leaf < mesh.leaf_count(); ++leaf) {
        CAPTURE(leaf);
        const glm::ivec2 at(pixel_of(camera, plain, middle(mesh, weights, leaf)));
        const glm::vec3 light = plain.light(at.x, at.y) / linear_light(plain_color);
        CHECK(glm::distance(picture.light(at.x, at.y), light * color_of(leaf)) < 0.02F);
    }
}

std::vector<Hierarchy> shapes_with_height(std::initializer_list<std::string_view> names) {
    std::vector<Hierarchy> keys;
    for (const std::string_view name : names) {
        ShapeBudget budget;
        budget.leaves = 800;
        keys.push_back(make_key(*find_shape(name), budget));
        Field height{"height", FieldKind::scalar, {}};
        for (const glm::vec3& p : keys.back().positions) height.values.push_back(p.y);
        keys.back().fields.push_back(std::move(height));
    }
    return keys;
}

}  // namespace

TEST_CASE("a scalar field has the colors of its scale, for any weights") {
    const EglContext context;
    const TestSurface square = surface_with_fields(keys_with_fields());
    Renderer renderer;
    renderer.upload(square.mesh, square.form);
    renderer.set_field(&square.mesh.fields[0]);
    OffscreenTarget target(400, 400, 1);
    const Camera camera = camera_on(square, target, 0, 0);
    for (const ColorMap map : color_maps())
        for (const std::array<float, 2> weights :
             {std::array{1.0F, 0.0F}, {0.0F, 1.0F}, {0.5F, 0.5F}, {1.5F, -0.5F}}) {
            Display display;
            const Picture plain = take_picture(renderer, target, camera, weights, display);
            display.coloring = Coloring::field;
            display.scale = {map, {-0.9F, 1.4F}};
            const Picture picture = take_picture(renderer, target, camera, weights, display);
            check_leaves(square.mesh, weights, camera, plain, picture, [&](std::size_t leaf) {
                return linear_light(display.scale.color(field_in_middle(square.mesh, 0, weights, leaf)[0]));
            });
            display.wireframe = true;  // through the other shader stages
            CHECK(count_differences(take_picture(renderer, target, camera, weights, display), picture, 8) <
                  40000);
        }
}

TEST_CASE("a color field is mixed as light, between vertices and between keys") {
    const EglContext context;
    const TestSurface square = surface_with_fields(keys_with_fields());
    Renderer renderer;
    renderer.upload(square.mesh, square.form);
    renderer.set_field(&square.mesh.fields[1]);
    OffscreenTarget target(400, 400, 1);
    const Camera camera = camera_on(square, target, 0, 0);
    for (const std::array<float, 2> weights : {std::array{1.0F, 0.0F}, {0.0F, 1.0F}, {0.25F, 0.75F}}) {
        Display display;
        const Picture plain = take_picture(renderer, target, camera, weights, display);
        display.coloring = Coloring::field;
        const Picture picture = take_picture(renderer, target, camera, weights, display);
        check_leaves(square.mesh, weights, camera, plain, picture, [&](std::size_t leaf) {
            const std::vector<float> light = field_in_middle(square.mesh, 1, weights, leaf);
            return glm::vec3(light[0], light[1], light[2]);
        });
    }
}

TEST_CASE("without a field, and after an upload of another surface, the picture is plain") {
    const EglContext context;
    const TestSurface square = surface_with_fields(keys_with_fields());
    const float both[] = {0.5F, 0.5F};
    Renderer renderer;
    renderer.upload(square.mesh, square.form);
    OffscreenTarget target(200, 200, 1);
    const Camera camera = camera_on(square, target, 0, 0);
    Display display;
    const Picture plain = take_picture(renderer, target, camera, both, display);
    display.coloring = Coloring::field;
    CHECK(take_picture(renderer, target, camera, both, display) == plain);
    renderer.set_field(&square.mesh.fields[0]);
    CHECK_FALSE(take_picture(renderer, target, camera, both, display) == plain);
    renderer.set_field(nullptr);
    CHECK(take_picture(renderer, target, camera, both, display) == plain);
    renderer.set_field(&square.mesh.fields[1]);
    renderer.upload(square.mesh, square.form);
    CHECK(take_picture(renderer, target, camera, both, display) == plain);
    renderer.set_field(&square.mesh.fields[0]);
    const Picture field = take_picture(renderer, target, camera, both, display);
    renderer.reload_shaders();
    CHECK(take_picture(renderer, target, camera, both, display) == field);
}

TEST_CASE("a field blended by the processor equals the one blended by the GPU") {
    const EglContext context;
    const auto names = {"sphere", "star", "bone", "cushion", "icosahedron"};
    std::vector<Hierarchy> keys = shapes_with_height({"sphere", "star", "bone", "cushion", "icosahedron"});
    const TestSurface five = surface_with_fields(keys);
    REQUIRE(five.mesh.key_count() == names.size());
    OffscreenTarget target(320, 240, 1);
    const Camera camera = camera_on(five, target);
    Display display;
    display.coloring = Coloring::field;
    display.scale.range = {-1.4F, 1.4F};
    Renderer renderer;
    renderer.upload(five.mesh, five.form);
    renderer.set_field(&five.mesh.fields[0]);
    const std::array<float, 5> weights{0.2F, 0.3F, 0.1F, 0.4F, 0};
    const Picture by_processor = take_picture(renderer, target, camera, weights, display);
    const std::array<float, 5> others{0.1F, 0.6F, 0.1F, 0.2F, 0};
    const Picture other = take_picture(renderer, target, camera, others, display);

    keys.pop_back();
    const TestSurface four = surface_with_fields(keys);
    Renderer on_gpu;
    on_gpu.upload(four.mesh, four.form);
    on_gpu.set_field(&four.mesh.fields[0]);
    const Picture by_gpu = take_picture(on_gpu, target, camera, std::span(weights).first(4), display);
    const Picture other_by_gpu = take_picture(on_gpu, target, camera, std::span(others).first(4), display);
    // The normals differ a little: the processor takes those of the blended surface.
    CHECK(count_differences(by_processor, by_gpu, 12) < 100);
    CHECK(count_differences(other, other_by_gpu, 12) < 100);
    CHECK(count_differences(by_processor, other, 3) > 3000);
}

TEST_CASE("a field that holds the height shows the height in the picture, for any morph") {
    const EglContext context;
    const TestSurface surface = surface_with_fields(shapes_with_height({"sphere", "star", "bone"}));
    Renderer renderer;
    renderer.upload(surface.mesh, surface.form);
    renderer.set_field(&surface.mesh.fields[0]);
    OffscreenTarget target(400, 400, 1);
    const Camera camera = camera_on(surface, target, 0, 0);
    Display display;
    display.coloring = Coloring::field;
    Renderer empty;
    const Picture background = take_picture(empty, target, camera, {});
    // Two values with a step between them: a line at a height.
    display.scale = {ColorMap::coolwarm, {0.2F, 0.2001F}};
    for (const std::array<float, 3> weights :
         {std::array{1.0F, 0.0F, 0.0F}, {0.3F, 0.4F, 0.3F}, {0.5F, -0.5F, 1.0F}}) {
        const Picture picture = take_picture(renderer, target, camera, weights, display);
        int checked = 0;
        int wrong = 0;
        const Buffer<glm::vec3> positions = morph(surface.mesh, weights);
        for (const glm::vec3& p : positions) {
            if (std::abs(p.y - 0.2F) < 0.06F) continue;
            const glm::vec3 way = p - camera.eye();
            const auto hit =
                first_hit(surface.mesh.triangles, positions, {camera.eye(), p - 0.03F * glm::normalize(way)});
            if (hit) continue;  // behind another part
            const glm::ivec2 at(pixel_of(camera, picture, p));
            const glm::vec3 light = picture.light(at.x, at.y);
            if (light == background.light(at.x, at.y)) continue;  // at the rim
            ++checked;
            wrong += (light.r > light.b) == (p.y > 0.2F) ? 0 : 1;
        }
        CHECK(wrong == 0);
        CHECK(checked > 150);
    }
}

TEST_CASE("the checkerboard shows the place of each point in its root, compared with literal level maps") {
    const EglContext context;
    const std::vector<Hierarchy> keys = two_keys_of_a_square();
    const TestSurface square = surface_of(keys);
    const UnionMesh& mesh = square.mesh;
    const float both[] = {0.5F, 0.5F};
    Renderer renderer;
    renderer.upload(mesh, square.form);
    OffscreenTarget target(800, 800, 1);
    const Camera camera = camera_on(square, target, 0, 0);
    Display display;
    display.coloring = Coloring::checker;
    const Picture picture = take_picture(renderer, target, camera, both, display);
    const std::vector<LeafPath> paths = leaf_paths(mesh.tags);
    constexpr double cells = 8;
    int checked = 0;
    int light_ones = 0;
    for (std::size_t leaf = 0; leaf < mesh.leaf_count(); ++leaf) {
        const glm::dmat3 in_root = level_map(paths[leaf].path, mesh.tags[leaf].level());
        const auto& [a, b, c] = mesh.triangles[leaf];
        for (double u = 0.02; u < 1; u += 0.03)
            for (double v = 0.02; u + v < 1; v += 0.03) {
                const glm::dvec3 place = in_root * glm::dvec3(1 - u - v, u, v) * cells;
                // Not where two cells meet.
                const glm::dvec3 off = glm::abs(place - glm::round(place));
                if (std::min({off.x, off.y, off.z}) < 0.1) continue;
                const bool is_light =
                    std::fmod(std::floor(place.x) + std::floor(place.y) + std::floor(place.z), 2) != 0;
                const auto& p = mesh.positions[0];
                const glm::vec3 point = static_cast<float>(1 - u - v) * p[a] + static_cast<float>(u) * p[b] +
                                        static_cast<float>(v) * p[c];
                const glm::ivec2 at(pixel_of(camera, picture, point));
                const float light = picture.light(at.x, at.y).r;
                REQUIRE((light > 0.25F) == is_light);
                ++checked;
                light_ones += is_light ? 1 : 0;
            }
    }
    CHECK(checked > 1000);
    CHECK(light_ones > checked / 3);
    CHECK(light_ones < 2 * checked / 3);
}

TEST_CASE("the checkerboard does not depend on the bisection of the union") {
    const EglContext context;
    const TestSurface alone = surface_of_shapes({"star"}, 3000);
    const TestSurface with_others = surface_of_shapes({"star", "bone", "cushion"}, 3000);
    REQUIRE(with_others.mesh.leaf_count() > alone.mesh.leaf_count());
    OffscreenTarget target(400, 300, 1);
    const Camera camera = camera_on(alone, target);
    Display display;
    display.coloring = Coloring::checker;
    Renderer renderer;
    renderer.upload(alone.mesh, alone.form);
    const Picture first = take_picture(renderer, target, camera, one, display);
    renderer.upload(with_others.mesh, with_others.form);
    const float weights[] = {1, 0, 0};
    const Picture second = take_picture(renderer, target, camera, weights, display);
    const Picture plain = take_picture(renderer, target, camera, weights);
    CHECK(count_differences(first, second, 12) < 300);
    CHECK(count_differences(first, plain, 12) > 5000);
    // From far away it becomes uniform, without a pattern of its own.
    Camera far = camera;
    far.zoom(0.12F, {0, 0}, 4.0F / 3);
    display.shading = Shading::smooth;
    const Picture small = take_picture(renderer, target, far, weights, display);
    CHECK(count_pixels(small, [](glm::vec3 light) { return light.r > 0.75F; }) == 0);
}
