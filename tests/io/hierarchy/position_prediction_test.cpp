#include "io/hierarchy/position_prediction.h"

#include <cmath>
#include <vector>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "hierarchy/random_families.h"
#include "io/hierarchy/position_planes.h"

namespace interleaf {

namespace {

/// A surface of \p height over a sheet of 8 squares, bisected \p rounds times everywhere.
template <typename Height>
Hierarchy uniform_sheet(unsigned rounds, Height height) {
    std::vector<glm::vec3> corners;
    for (int y = 0; y <= 2; ++y)
        for (int x = 0; x <= 4; ++x) corners.emplace_back(x, y, height(float(x), float(y)));
    // The diagonal of a square is the refinement edge of both triangles.
    AdaptiveMesh* self = nullptr;
    AdaptiveMesh mesh(testing::sheet(4, 2), corners, [&](Index a, Index b, auto...) {
        const glm::vec3 middle = 0.5F * (self->positions()[a] + self->positions()[b]);
        return glm::vec3(middle.x, middle.y, height(middle.x, middle.y));
    });
    self = &mesh;
    std::vector<Index> leaves;
    for (unsigned round = 0; round < rounds; ++round) {
        leaves.resize(mesh.leaf_count());
        for (Index leaf = 0; leaf < mesh.leaf_count(); ++leaf) leaves[leaf] = leaf;
        mesh.refine(leaves);
    }
    return mesh.freeze();
}

/// The root mean square of the differences between positions and expected positions at level \p level.
double error_at(const Hierarchy& key, unsigned level) {
    const Connectivity connectivity = open_decisions(key).connectivity;
    double sum = 0;
    double count = 0;
    for (Index v = 0; v < key.vertex_count(); ++v) {
        if (connectivity.levels[v] != level) continue;
        const glm::dvec3 expected = predicted_position(v, connectivity, key.positions);
        const double error = glm::distance(expected, glm::dvec3(key.positions[v]));
        sum += error * error;
        ++count;
    }
    REQUIRE(count > 0);
    return std::sqrt(sum / count);
}

}  // namespace

TEST_CASE("a paraboloid is predicted exactly, away from edges without history") {
    const Hierarchy key =
        uniform_sheet(9, [](float x, float y) { return 0.25F * x * x - 0.5F * x * y + 0.125F * y * y; });
    for (const unsigned level : {3U, 4U, 5U, 6U, 7U, 8U}) {
        CAPTURE(level);
        CHECK(error_at(key, level) < 1e-6);
    }
}

TEST_CASE("the error falls with at least the third power of the edge length") {
    const Hierarchy key = uniform_sheet(
        10, [](float x, float y) { return static_cast<float>(std::sin(1.3 * x + 0.4) * std::cos(0.9 * y)); });
    // Two levels halve the edges. Below 1e-7, the precision of floats stops the fall.
    CHECK(error_at(key, 7) < error_at(key, 5) / 6.5);
    CHECK(error_at(key, 6) < error_at(key, 4) / 6.5);
}

TEST_CASE("vertices are taken level by level") {
    const std::vector<std::uint8_t> levels = {0, 0, 0, 2, 1, 3, 1, 2};
    const Buffer<Index> order = prediction_order(levels);
    CHECK(std::vector<Index>(order.begin(), order.end()) == std::vector<Index>{0, 1, 2, 4, 6, 3, 7, 5});
}

}  // namespace interleaf
