// Tests of pictures of roots that do not match: the marks, and whether the camera sees them.
#include "app/pictures/mismatch_picture.h"

#include <algorithm>
#include <cmath>
#include <random>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "app/pictures/tube.h"
#include "hierarchy/checker.h"
#include "hierarchy/color.h"
#include "hierarchy/leaf_path.h"
#include "hierarchy/measure.h"
#include "io/samples.h"
#include "render/palette.h"
#include "render/pick.h"
#include "shapes/brezel.h"
#include "shapes/shapes.h"

using namespace interleaf;

namespace {

constexpr float aspect = 4.0F / 3;

Hierarchy shape(const std::string& name) {
    return make_key(*find_shape(name), {.leaves = 3000, .tolerance = {}});
}

/// Root \p root with its refinement edge, or with its vertex opposite that.
RootPlace place_of(const Hierarchy& key, Index root, bool has_edge) {
    const Triangle& triangle = key.roots.triangles()[root];
    RootPlace place{.root = root};
    if (has_edge)
        place.edge = {triangle[1], triangle[2]};
    else
        place.vertex = triangle[0];
    return place;
}

glm::vec3 color_of(const MismatchPicture& picture, Index vertex) {
    const auto& values = picture.colors.values.front();
    return {values[3 * vertex], values[3 * vertex + 1], values[3 * vertex + 2]};
}

bool has_color(const MismatchPicture& picture, std::size_t triangle, glm::vec3 color) {
    return std::ranges::all_of(picture.mesh.triangles[triangle], [&](Index vertex) {
        return color_of(picture, vertex) == linear_light(color);
    });
}

/// Checks that all arrays have the right length and that every vertex exists.
void check_form(const MismatchPicture& picture) {
    const UnionMesh& mesh = picture.mesh;
    CHECK(mesh.tags.size() == mesh.leaf_count());
    CHECK(mesh.origins.size() == mesh.leaf_count());
    CHECK(mesh.positions.size() == 1);
    CHECK(mesh.positions.front().size() == mesh.vertex_count());
    CHECK(picture.form.products.size() == mesh.vertex_count());
    CHECK(picture.colors.values.front().size() == 3 * mesh.vertex_count());
    for (const Triangle& triangle : mesh.triangles)
        for (const Index vertex : triangle) REQUIRE(vertex < mesh.vertex_count());
}

/// The position of \p point in the picture, -1 to 1.
glm::vec3 device_coordinates(const Camera& camera, glm::vec3 point) {
    const glm::vec4 clip = camera.projection(aspect) * camera.view() * glm::vec4(point, 1);
    return glm::vec3(clip) / clip.w;
}

/// Of about 40 sampled triangles from \p begin on, the number that the picture shows unhidden, and all.
struct Seen {
    std::size_t triangles = 0;
    std::size_t all = 0;
};

Seen seen_from(const MismatchPicture& picture, std::size_t begin) {
    const auto& positions = picture.mesh.positions.front();
    Seen seen;
    const std::size_t step = 1 + (picture.mesh.leaf_count() - begin) / 40;
    for (std::size_t t = begin; t < picture.mesh.leaf_count(); t += step) {
        const auto& [a, b, c] = picture.mesh.triangles[t];
        const glm::vec3 middle = (positions[a] + positions[b] + positions[c]) / 3.0F;
        const glm::vec3 place = device_coordinates(picture.camera, middle);
        ++seen.all;
        if (std::max({std::abs(place.x), std::abs(place.y), std::abs(place.z)}) > 1) continue;
        const auto hit = first_hit(picture.mesh.triangles, positions, {picture.camera.eye(), middle});
        // The ray meets the triangle itself, or another one of the tube that faces the eye.
        if (!hit || hit->triangle >= begin) ++seen.triangles;
    }
    return seen;
}

}  // namespace

TEST_CASE("a tube is closed, runs along its line, and its normals point outwards") {
    std::mt19937 random(3);
    std::uniform_real_distribution<float> coordinate(-1, 1);
    for (const std::size_t count : {1U, 2U, 3U, 20U}) {
        std::vector<glm::vec3> line(count);
        glm::vec3 point(0);
        for (glm::vec3& next : line) {
            point += glm::vec3(0.4F, 0.2F * coordinate(random), 0.2F * coordinate(random));
            next = point;
        }
        const Tube tube = tube_along(line, 0.01F);
        CHECK(is_closed_manifold(tube.triangles));
        CHECK(euler_number(tube.triangles) == 2);
        CHECK(measure(tube.triangles, tube.positions).volume > 0);
        REQUIRE(tube.normals.size() == tube.positions.size());
        for (std::size_t v = 0; v < tube.positions.size(); ++v) {
            float nearest = 1;
            for (const glm::vec3 at : line) nearest = std::min(nearest, glm::distance(at, tube.positions[v]));
            CHECK(nearest == doctest::Approx(0.01F).epsilon(1e-3));
            CHECK(glm::length(tube.normals[v]) == doctest::Approx(1).epsilon(1e-4));
        }
    }
    // Coincident points define no axis, but still give a surface.
    const std::vector<glm::vec3> one_place(3, glm::vec3(1, 2, 3));
    const Tube tube = tube_along(one_place, 0.5F);
    CHECK(is_closed_manifold(tube.triangles));
    for (const glm::vec3 position : tube.positions)
        CHECK(glm::distance(position, one_place.front()) == doctest::Approx(0.5F));
}

TEST_CASE("the root is filled and nothing else, and the surface is that of the key") {
    const Hierarchy key = shape("cushion");
    for (const Index root : {0U, 7U, 19U}) {
        CAPTURE(root);
        const MismatchPicture picture = mismatch_picture(key, place_of(key, root, true), aspect);
        check_form(picture);
        REQUIRE(picture.leaf_count == key.leaf_count());
        const std::vector<Leaf> leaves = leaves_of(key);
        const std::vector<LeafPath> paths =
            leaf_paths(std::span(picture.mesh.tags).first(picture.leaf_count));
        for (std::size_t leaf = 0; leaf < leaves.size(); ++leaf) {
            REQUIRE(has_color(picture, leaf, paths[leaf].root == root ? mismatch_root_color : plain_color));
            for (std::size_t corner = 0; corner < 3; ++corner)
                REQUIRE(picture.mesh.positions.front()[picture.mesh.triangles[leaf][corner]] ==
                        key.positions[leaves[leaf].vertices[corner]]);
        }
        for (std::size_t t = picture.leaf_count; t < picture.mesh.leaf_count(); ++t)
            REQUIRE(has_color(picture, t, mismatch_edge_color));
    }
}

TEST_CASE("the tube runs along the whole edge, bisected or not") {
    const Hierarchy refined = shape("sphere");
    const Hierarchy coarse = shape("icosahedron");
    for (const Hierarchy* const key : {&refined, &coarse}) {
        const RootPlace place = place_of(*key, 4, true);
        const MismatchPicture picture = mismatch_picture(*key, place, aspect);
        const auto& positions = picture.mesh.positions.front();
        const Triangle first = picture.mesh.triangles[picture.leaf_count];
        const auto tube = std::span(positions).subspan(*std::ranges::min_element(first));
        const glm::vec3 from = key->positions[place.edge[0]];
        const glm::vec3 to = key->positions[place.edge[1]];
        // The edge of a sphere key is an arc over the straight line: as long as the angle says.
        for (const float part : {0.0F, 0.25F, 0.5F, 0.75F, 1.0F}) {
            const glm::vec3 straight = from + part * (to - from);
            const glm::vec3 at = key == &refined ? glm::normalize(straight) : straight;
            const bool is_vertex = key == &refined || part == 0 || part == 1;
            if (!is_vertex) continue;
            const float nearest = glm::distance(
                at, *std::ranges::min_element(tube, {}, [&](glm::vec3 p) { return glm::distance(at, p); }));
            CHECK(nearest < 0.06F);
        }
        for (const glm::vec3 p : tube) {
            const float along = glm::dot(p - from, to - from) / glm::dot(to - from, to - from);
            CHECK(along > -0.1F);
            CHECK(along < 1.1F);
        }
    }
}

TEST_CASE("the camera sees root and edge of every root, in hollows, too, and of small roots as well") {
    for (const char* const name : {"icosahedron", "bone", "cushion", "star", "sphere", "brezel"}) {
        CAPTURE(name);
        const Hierarchy key = shape(name);
        const Index step = key.roots.triangle_count() > 20 ? 7 : 1;
        for (Index root = 0; root < key.roots.triangle_count(); root += step)
            for (const bool has_edge : {true, false}) {
                CAPTURE(root);
                CAPTURE(has_edge);
                const RootPlace place = place_of(key, root, has_edge);
                const MismatchPicture picture = mismatch_picture(key, place, aspect);
                const Seen mark = seen_from(picture, picture.leaf_count);
                REQUIRE(mark.all > 0);
                CHECK(2 * mark.triangles >= mark.all);
                float reach = 0;
                for (const Index vertex : key.roots.triangles()[root]) {
                    const glm::vec3 at = device_coordinates(picture.camera, key.positions[vertex]);
                    CHECK(std::max(std::abs(at.x), std::abs(at.y)) < 1);
                    reach = std::max({reach, std::abs(at.x), std::abs(at.y)});
                }
                CHECK(reach > 0.1F);
            }
    }
}

TEST_CASE("where there is no root, the whole key is shown and nothing is marked") {
    const Hierarchy key = shape("star");
    const MismatchPicture picture = mismatch_picture(key, {}, aspect);
    check_form(picture);
    CHECK(picture.mesh.leaf_count() == key.leaf_count());
    for (std::size_t leaf = 0; leaf < key.leaf_count(); ++leaf)
        REQUIRE(has_color(picture, leaf, plain_color));
    for (const glm::vec3 position : key.positions) {
        const glm::vec3 at = device_coordinates(picture.camera, position);
        REQUIRE(std::max({std::abs(at.x), std::abs(at.y), std::abs(at.z)}) < 1);
    }
}

TEST_CASE("keys without area, or with huge coordinates, are pictured, too") {
    const RootComplex roots(3, {{0, 1, 2}});
    const float huge = std::numeric_limits<float>::max();
    for (const std::vector<glm::vec3>& corners : {std::vector<glm::vec3>{{1, 1, 1}, {1, 1, 1}, {1, 1, 1}},
                                                  {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}},
                                                  {{-huge, 0, 0}, {huge, 0, 0}, {0, huge, huge}}}) {
        const Hierarchy key = unrefined(roots, corners);
        REQUIRE(check(key).empty());
        check_form(mismatch_picture(key, place_of(key, 0, true), aspect));
        check_form(mismatch_picture(key, place_of(key, 0, false), aspect));
    }
}

TEST_CASE("a caption names the key and the place in it") {
    CHECK(caption_of("bone", {}) == "bone");
    CHECK(caption_of("bone", {.root = 12, .edge = {3, 7}}) == "bone: root 12, edge (3, 7)");
    CHECK(caption_of("bone", {.root = 12, .vertex = 5}) == "bone: root 12, vertex 5");
}

TEST_CASE("key and reference have their own places") {
    RootMismatch mismatch;
    mismatch.root = 1;
    mismatch.edge = {2, 3};
    mismatch.reference_root = 4;
    mismatch.reference_vertex = 5;
    CHECK(caption_of("", place_in_key(mismatch)) == ": root 1, edge (2, 3)");
    CHECK(caption_of("", place_in_reference(mismatch)) == ": root 4, vertex 5");
}
