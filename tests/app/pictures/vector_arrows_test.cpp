// Arrows point along the vectors, one per cell, where the surface is visible.
#include "app/pictures/vector_arrows.h"

#include <cmath>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "family/new_family.h"
#include "hierarchy/adaptive_mesh.h"
#include "hierarchy/measure.h"

using namespace interleaf;

namespace {

/// A square in the plane z = 0 with the vectors (1, 2) everywhere.
Family square_family() {
    const RootComplex roots(4, {{0, 1, 2}, {3, 2, 1}});
    const std::vector<glm::vec3> corners = {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {2, 2, 0}};
    AdaptiveMesh mesh(roots, corners);
    for (int round = 0; round < 8; ++round) {
        std::vector<Index> all;
        for (Index leaf = 0; leaf < mesh.leaf_bound(); ++leaf) all.push_back(leaf);
        mesh.refine(all);
    }
    Hierarchy key = mesh.freeze();
    key.fields = {{"v x", FieldKind::scalar, Buffer<float>(key.positions.size(), 1)},
                  {"v y", FieldKind::scalar, Buffer<float>(key.positions.size(), 2)}};
    std::vector<Key> keys;
    keys.push_back({"square", std::move(key)});
    return family_of_keys("square", std::move(keys));
}

}  // namespace

TEST_CASE("arrows point along the vectors, at most one per cell, and only where nothing is in front") {
    constexpr int side = 200;
    constexpr float cell = 20;
    const Family family = square_family();
    const Weights weights = {{0, 1.0}};
    const UnionMesh mesh = unite(family, weights);
    Camera camera;
    camera.view_all(extent_of(family.keys[0].hierarchy->positions), 1);
    VectorArrows arrows;
    arrows.follow(family, weights, mesh, 1, std::nullopt);
    CHECK_FALSE(arrows.are_shown());
    const auto vector = vector_of(fields_of(family.keys), "v x");
    REQUIRE(vector);
    arrows.follow(family, weights, mesh, 1, vector);
    REQUIRE(arrows.are_shown());
    std::vector<float> depths(std::size_t{side} * side, 1);
    const std::vector<Arrow> all = arrows.arrows(mesh, weights, camera, {side, side, depths}, cell);
    CHECK(all.size() > 40);
    CHECK(all.size() <= 100);
    for (const Arrow& arrow : all) {
        const glm::vec2 along = arrow.to - arrow.from;
        CHECK(along.y / along.x == doctest::Approx(-2).epsilon(0.01));  // y is down
        CHECK(glm::length(along) == doctest::Approx(1.5F * cell).epsilon(0.01));
    }
    depths.assign(depths.size(), 0);
    CHECK(arrows.arrows(mesh, weights, camera, {side, side, depths}, cell).empty());
}
