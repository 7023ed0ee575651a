#include "hierarchy/turning.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include "hierarchy/measure.h"
#include "hierarchy/morph.h"
#include "hierarchy/random_families.h"

using namespace interleaf;
using namespace interleaf::testing;

namespace {

UnionMesh turning_union(const std::vector<const Hierarchy*>& keys) {
    UnionMesh mesh = unite(keys);
    mesh.turning.emplace(mesh);
    return mesh;
}

UnionMesh turning_union(const std::vector<Hierarchy>& keys) {
    std::vector<const Hierarchy*> pointers;
    pointers.reserve(keys.size());
    for (const Hierarchy& key : keys) pointers.push_back(&key);
    return turning_union(pointers);
}

float largest_distance(std::span<const glm::vec3> a, std::span<const glm::vec3> b) {
    float largest = 0;
    for (std::size_t v = 0; v < a.size(); ++v) largest = std::max(largest, glm::distance(a[v], b[v]));
    return largest;
}

Buffer<glm::vec3> straight(const UnionMesh& mesh, std::span<const float> weights) {
    Buffer<glm::vec3> positions;
    weighted_sum(mesh.positions, weights, positions);
    return positions;
}

Hierarchy moved(Hierarchy key, const glm::quat& rotation, const glm::vec3& shift) {
    for (glm::vec3& position : key.positions) position = rotation * position + shift;
    return key;
}

glm::quat turn(float degrees, const glm::vec3& axis) {
    return glm::angleAxis(degrees * std::numbers::pi_v<float> / 180, glm::normalize(axis));
}

/// The unit sphere over the octahedron, in 4,096 leaves.
Hierarchy sphere() {
    const std::vector<glm::vec3> corners = {{1, 0, 0},  {-1, 0, 0}, {0, 1, 0},
                                            {0, -1, 0}, {0, 0, 1},  {0, 0, -1}};
    AdaptiveMesh* known = nullptr;
    AdaptiveMesh mesh(octahedron(), corners, [&](Index a, Index b, Index) {
        return glm::normalize(known->positions()[a] + known->positions()[b]);
    });
    known = &mesh;
    while (mesh.leaf_count() < 4096) {
        std::vector<Index> all(mesh.leaf_bound());
        std::iota(all.begin(), all.end(), Index{0});
        mesh.refine(all);
    }
    return mesh.freeze();
}

/// A rod along x from -3 to 3, which a turn by \p degrees bends around z within one unit of its length.
Hierarchy rod(Hierarchy key, double degrees) {
    const double angle = degrees * std::numbers::pi / 180;
    for (glm::vec3& position : key.positions) {
        const double along = static_cast<double>(position.x);
        const double radius = 0.4 * std::sqrt(1 - std::pow(std::abs(along), 6));
        const glm::dvec2 side =
            glm::dvec2(position.y, position.z) / std::max(std::sqrt(1 - along * along), 1e-6);
        const double bent = angle * std::clamp(3 * along + 0.5, 0.0, 1.0);
        const glm::dvec2 tangent(std::cos(bent), std::sin(bent));
        glm::dvec2 middle(3 * along, 0);
        if (angle > 0 && 3 * along > -0.5)
            middle = glm::dvec2(std::sin(bent), 1 - std::cos(bent)) / angle - glm::dvec2(0.5, 0) +
                     std::max(3 * along - 0.5, 0.0) * tangent;
        const glm::dvec2 place = middle + radius * side.x * glm::dvec2(-tangent.y, tangent.x);
        position = glm::dvec3(place.x, place.y, radius * side.y);
    }
    return key;
}

}  // namespace

TEST_CASE("a turning blend is each key at its weight, 2,000 hierarchies") {
    for (const std::size_t key_count : {1U, 2U, 3U, 5U})
        for_random_families(500, key_count, [&](const RandomFamily& family) {
            CAPTURE(family.seed);
            const UnionMesh mesh = turning_union(family.key_pointers());
            for (std::size_t key = 0; key < key_count; ++key) {
                std::vector<float> weights(key_count, 0);
                weights[key] = 1;
                const Buffer<glm::vec3> positions = morph(mesh, weights);
                REQUIRE(largest_distance(positions, mesh.positions[key]) <=
                        1e-6F * bounding_box(positions).diagonal());
            }
        });
}

TEST_CASE("keys that differ by translations blend straight, for any weights that sum to 1") {
    for_random_families(300, 1, [](const RandomFamily& family) {
        CAPTURE(family.seed);
        Random random(family.seed);
        const Hierarchy& key = family.keys[0];
        const UnionMesh mesh = turning_union(std::vector{key, moved(key, turn(0, {1, 0, 0}), random.point()),
                                                         moved(key, turn(0, {1, 0, 0}), random.point())});
        const auto a = static_cast<float>(4 * random.unit() - 2);
        const auto b = static_cast<float>(4 * random.unit() - 2);
        const std::vector<float> weights = {a, b, 1 - a - b};
        REQUIRE(largest_distance(morph(mesh, weights), straight(mesh, weights)) <= 1e-4F);
    });
}

TEST_CASE("a key that moves rigidly stays rigid on its way, and beyond") {
    for_random_families(300, 1, [](const RandomFamily& family) {
        CAPTURE(family.seed);
        Random random(family.seed);
        const Hierarchy& key = family.keys[0];
        const auto some_turn = [&] { return turn(static_cast<float>(80 * random.unit()), random.point()); };
        const UnionMesh mesh = turning_union(std::vector{key, moved(key, some_turn(), random.point()),
                                                         moved(key, some_turn(), random.point())});
        const auto a = static_cast<float>(1.5 * random.unit() - 0.25);
        const auto b = static_cast<float>(1.5 * random.unit() - 0.25);
        const Buffer<glm::vec3> positions = morph(mesh, std::vector{a, b, 1 - a - b});
        // Components keep the centers of their weighted sums, so only their edges tell.
        for (const Triangle& leaf : mesh.triangles)
            for (unsigned k = 0; k < 3; ++k)
                REQUIRE(std::abs(glm::distance(positions[leaf[k]], positions[leaf[(k + 1) % 3]]) -
                                 glm::distance(mesh.positions[0][leaf[k]],
                                               mesh.positions[0][leaf[(k + 1) % 3]])) <= 2e-5F);
    });
}

TEST_CASE("halfway through a turn by 170 degrees about an axis is the turn by 85 degrees") {
    const Hierarchy key = rod(sphere(), 40);
    const UnionMesh mesh = turning_union(std::vector{key, moved(key, turn(170, {1, 2, 3}), {})});
    const UnionMesh between = unite(std::vector<const Hierarchy*>{&key});
    const Buffer<glm::vec3> positions = morph(mesh, std::vector{0.5F, 0.5F});
    const glm::quat half = turn(85, {1, 2, 3});
    const glm::vec3 shift = positions[0] - half * between.positions[0][0];
    for (std::size_t v = 0; v < positions.size(); ++v)
        REQUIRE(glm::distance(positions[v], half * between.positions[0][v] + shift) <= 1e-4F);
}

TEST_CASE("a rod that bends keeps its area and its volume") {
    const Hierarchy key = sphere();
    for (const double degrees : {60, 90, 120}) {
        CAPTURE(degrees);
        const UnionMesh mesh = turning_union(std::vector{rod(key, 0), rod(key, degrees)});
        const Measures from = measure(mesh.triangles, mesh.positions[0]);
        for (const float t : {0.25F, 0.5F, 0.75F}) {
            const Measures between = measure(mesh.triangles, morph(mesh, std::vector{1 - t, t}));
            CHECK(between.volume / from.volume == doctest::Approx(1).epsilon(0.02));
            CHECK(between.area / from.area == doctest::Approx(1).epsilon(0.03));
        }
        if (degrees >= 90) {
            const Measures shrunk = measure(mesh.triangles, straight(mesh, std::vector{0.5F, 0.5F}));
            CHECK(shrunk.volume / from.volume < 0.85);
        }
    }
}

TEST_CASE("a turning blend does not depend on the order of the keys") {
    for_random_families(300, 3, [](const RandomFamily& family) {
        CAPTURE(family.seed);
        const auto keys = family.key_pointers();
        const UnionMesh mesh = turning_union(keys);
        const UnionMesh other = turning_union(std::vector{keys[2], keys[0], keys[1]});
        const Buffer<glm::vec3> a = morph(mesh, std::vector{0.2F, 0.5F, 0.3F});
        const Buffer<glm::vec3> b = morph(other, std::vector{0.3F, 0.2F, 0.5F});
        REQUIRE(largest_distance(a, b) <= 1e-3F);
    });
}

TEST_CASE("on the same leaves, a key of weight 0 has no part in a turning blend") {
    for_random_families(300, 3, [](const RandomFamily& family) {
        CAPTURE(family.seed);
        UnionMesh mesh = turning_union(family.key_pointers());
        const Buffer<glm::vec3> three = morph(mesh, std::vector{0.4F, 0.6F, 0.0F});
        mesh.positions.pop_back();
        mesh.turning.emplace(mesh);
        REQUIRE(largest_distance(three, morph(mesh, std::vector{0.4F, 0.6F})) <= 1e-5F);
    });
}

TEST_CASE("where a key of weight 0 refines the leaves, a turning blend moves by a thousandth at most") {
    const Hierarchy fine = sphere();
    AdaptiveMesh twice(fine, [](Index, Index, Index) { return glm::vec3(0); });
    std::vector<Index> half(twice.leaf_bound() / 2);
    std::iota(half.begin(), half.end(), Index{0});
    twice.refine(half);
    const Hierarchy finer = twice.freeze();

    const std::vector<Hierarchy> keys = {rod(fine, 0), rod(fine, 100), finer};
    const UnionMesh two = turning_union(std::vector<const Hierarchy*>{&keys[0], &keys[1]});
    const UnionMesh three = turning_union(keys);
    REQUIRE(three.leaf_count() > two.leaf_count());
    const Buffer<glm::vec3> before = morph(two, std::vector{0.5F, 0.5F});
    const Buffer<glm::vec3> after = morph(three, std::vector{0.5F, 0.5F, 0.0F});
    for (std::size_t v = 0; v < fine.vertex_count(); ++v)
        REQUIRE(glm::distance(before[two.own_vertices[0][v]], after[three.own_vertices[0][v]]) <=
                1e-3F * bounding_box(before).diagonal());
}

TEST_CASE("a small step of the weights is a small step of a turning blend") {
    const Hierarchy key = sphere();
    const UnionMesh mesh = turning_union(std::vector{rod(key, 0), rod(key, 110), rod(key, 60)});
    const float size = bounding_box(mesh.positions[0]).diagonal();
    Random random(7);
    for (int n = 0; n < 100; ++n) {
        const auto a = static_cast<float>(3 * random.unit() - 1);
        const auto b = static_cast<float>(3 * random.unit() - 1);
        const float step = 1e-3F;
        const float moved_by = largest_distance(morph(mesh, std::vector{a, b, 1 - a - b}),
                                                morph(mesh, std::vector{a + step, b, 1 - a - b - step}));
        REQUIRE(moved_by <= 4 * step * size);
    }
}

TEST_CASE("keys of no area and weights that cancel each other do a turning blend no harm") {
    const Hierarchy key = rod(sphere(), 0);
    Hierarchy point = key;
    std::ranges::fill(point.positions, glm::vec3(1, 2, 3));
    Hierarchy line = key;
    for (glm::vec3& position : line.positions) position.y = position.z = 0;
    Hierarchy mirrored = key;
    for (glm::vec3& position : mirrored.positions) position.x = -position.x;
    const UnionMesh mesh = turning_union(std::vector{key, point, line, mirrored});
    for (const std::vector<float>& weights : {std::vector{0.25F, 0.25F, 0.25F, 0.25F},
                                              {0, 0.5F, 0.5F, 0},
                                              {1, 0, 0, -1},
                                              {0, 0, 0, 0},
                                              {1, -1, 1, -1}})
        for (const glm::vec3& position : morph(mesh, weights)) {
            REQUIRE(std::isfinite(position.x));
            REQUIRE(glm::length(position) < 20);
        }
    for (std::size_t k = 0; k < 4; ++k) {
        std::vector<float> weights(4, 0);
        weights[k] = 1;
        CHECK(largest_distance(morph(mesh, weights), mesh.positions[k]) <= 1e-5F);
    }
    const UnionMesh points = turning_union(std::vector{point, point});
    CHECK(largest_distance(morph(points, std::vector{0.5F, 0.5F}), points.positions[0]) <= 1e-6F);
}
