#include "hierarchy/vertex_normals.h"

#include <cmath>

#include "trials.h"
#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "hierarchy/morph.h"
#include "hierarchy/random_families.h"

using namespace interleaf;
using namespace interleaf::testing;

namespace {

/// Length of the longest vector, as a scale for differences.
float magnitude(const std::vector<glm::vec3>& vectors) {
    float largest = 0;
    for (const glm::vec3& v : vectors) largest = std::max(largest, glm::length(v));
    return largest;
}

std::vector<float> random_weights(Random& random, std::size_t count) {
    std::vector<float> weights(count);
    for (float& weight : weights) weight = static_cast<float>(2 * random.unit() - 0.5);
    return weights;
}

/// The weighted normals of the corners around each vertex of the blended mesh, at vertices that every key
/// has. At other vertices the form interpolates (rule 2), so the result is meaningless there.
std::vector<glm::dvec3> normals_of_blended_mesh(const UnionMesh& mesh, const std::vector<float>& weights) {
    std::vector<glm::dvec3> normals(mesh.vertex_count());
    const Buffer<glm::vec3> positions = morph(mesh, weights);
    for (std::size_t t = 0; t < mesh.leaf_count(); ++t) {
        const auto& [a, b, c] = mesh.triangles[t];
        const glm::dvec3 normal = glm::cross(glm::dvec3(positions[b]) - glm::dvec3(positions[a]),
                                             glm::dvec3(positions[c]) - glm::dvec3(positions[a]));
        for (unsigned k = 0; k < 3; ++k)
            normals[mesh.triangles[t][k]] += std::pow(2.0, mesh.tags[t].corner_exponent(k)) * normal;
    }
    return normals;
}

}  // namespace

TEST_CASE("the quadratic form gives the corner-weighted normals of the blended mesh, 10,200 hierarchies") {
    for_random_families(10200, 3, [](const RandomFamily& family) {
        CAPTURE(family.seed);
        Random random(family.seed);
        const UnionMesh mesh = unite(family.key_pointers());
        const std::vector<float> weights = random_weights(random, 3);
        const std::vector<glm::vec3> normals = morph_normals(normal_form(mesh), weights);
        const std::vector<glm::dvec3> expected = normals_of_blended_mesh(mesh, weights);
        const KeySet all = key_bit(0) | key_bit(1) | key_bit(2);
        const double scale = static_cast<double>(magnitude(normals));
        for (std::size_t v = 0; v < mesh.vertex_count(); ++v)
            if (mesh.vertices[v].keys == all)
                REQUIRE(glm::distance(glm::dvec3(normals[v]), expected[v]) <= 1e-4 * scale);
    });
}

TEST_CASE("another key of weight 0 refines the union and changes no normal, 10,200 hierarchies") {
    std::size_t refined = 0;
    for_random_families(10200, 3, [&](const RandomFamily& family) {
        CAPTURE(family.seed);
        Random random(family.seed);
        const UnionMesh two = unite(std::vector<const Hierarchy*>{&family.keys[0], &family.keys[1]});
        const UnionMesh three = unite(family.key_pointers());
        refined += three.leaf_count() > two.leaf_count() ? 1 : 0;
        std::vector<float> weights = random_weights(random, 2);
        const std::vector<glm::vec3> before = morph_normals(normal_form(two), weights);
        weights.push_back(0);
        const std::vector<glm::vec3> after = morph_normals(normal_form(three), weights);
        const float scale = magnitude(before);
        for (std::size_t key = 0; key < 2; ++key)
            for (std::size_t v = 0; v < family.keys[key].vertex_count(); ++v)
                REQUIRE(glm::distance(before[two.own_vertices[key][v]], after[three.own_vertices[key][v]]) <=
                        2e-5F * scale);
    });
    CHECK(refined > trials(1500));
}

TEST_CASE("a flat triangle has one normal direction everywhere, however it is bisected") {
    for (std::uint64_t seed = 1; seed <= trials(500); ++seed) {
        CAPTURE(seed);
        Random random(seed);
        const std::vector<glm::vec3> grid = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}, {1, 1, 0},
                                             {2, 1, 0}, {0, 2, 0}, {1, 2, 0}, {2, 2, 0}};
        AdaptiveMesh mesh(marked(sheet(2, 2), Marking::random, random), grid);
        refine_at_random(mesh, random, 8, 300);
        const Hierarchy key = mesh.freeze();
        const UnionMesh alone = unite(std::vector<const Hierarchy*>{&key});
        for (const glm::vec3& normal : morph_normals(normal_form(alone), std::vector<float>{1})) {
            REQUIRE(normal.x == 0);
            REQUIRE(normal.y == 0);
            REQUIRE(normal.z > 0);
        }
    }
}

TEST_CASE("a triangle without area contributes nothing, and no result is undefined") {
    AdaptiveMesh mesh(octahedron(), std::vector<glm::vec3>(6, glm::vec3(1)));
    mesh.refine(std::vector<Index>{0, 1, 2});
    const Hierarchy key = mesh.freeze();
    const UnionMesh alone = unite(std::vector<const Hierarchy*>{&key});
    for (const glm::vec3& normal : morph_normals(normal_form(alone), std::vector<float>{1}))
        CHECK(normal == glm::vec3(0));
}

TEST_CASE(
    "the normals of a blended surface are its corner-weighted ones, and a key of weight 0 changes none") {
    for_random_families(600, 3, [](const RandomFamily& family) {
        CAPTURE(family.seed);
        Random random(family.seed);
        const UnionMesh mesh = unite(family.key_pointers());
        const std::vector<float> weights = random_weights(random, 3);
        Buffer<glm::vec3> normals;
        surface_normals(mesh, weights, morph(mesh, weights), normals);
        const std::vector<glm::dvec3> expected = normals_of_blended_mesh(mesh, weights);
        const double scale = static_cast<double>(magnitude({normals.begin(), normals.end()}));
        for (std::size_t v = 0; v < mesh.vertex_count(); ++v)
            REQUIRE(glm::distance(glm::dvec3(normals[v]), expected[v]) <= 1e-4 * scale);

        // The first key alone, with the others at weight 0: as the key's own normals at its own vertices.
        const std::vector<float> first{1, 0, 0};
        surface_normals(mesh, first, morph(mesh, first), normals);
        const UnionMesh alone = unite(std::vector<const Hierarchy*>{family.key_pointers()[0]});
        const std::vector<glm::vec3> own = morph_normals(normal_form(alone), std::vector<float>{1});
        for (std::size_t v = 0; v < alone.vertex_count(); ++v)
            REQUIRE(glm::distance(normals[mesh.own_vertices[0][v]], own[v]) <= 1e-4F * magnitude(own));
    });
}
