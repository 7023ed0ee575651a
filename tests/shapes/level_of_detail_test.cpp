// Levels of detail of keys from formulas and of random keys, measured.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "trials.h"
#include <doctest/doctest.h>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "fit/mesh/space_triangle.h"
#include "fit/mesh/surface_distance.h"
#include "hierarchy/checker.h"
#include "hierarchy/detail/cut.h"
#include "hierarchy/detail/key_detail.h"
#include "hierarchy/detail/vertex_errors.h"
#include "hierarchy/detail/view_mesh.h"
#include "hierarchy/detail/view_refinement.h"
#include "hierarchy/greedy.h"
#include "hierarchy/random_surfaces.h"
#include "shapes/shapes.h"

using namespace interleaf;
using namespace interleaf::testing;

namespace {

struct LeafMesh {
    std::vector<Triangle> triangles;
    std::vector<glm::dvec3> positions;
};

LeafMesh leaf_mesh(const Hierarchy& key) {
    LeafMesh mesh{{}, {key.positions.begin(), key.positions.end()}};
    for (const Leaf& leaf : leaves_of(key)) mesh.triangles.push_back(leaf.vertices);
    return mesh;
}

/// The largest distance of the vertices of \p from, and of places on its triangles, from \p to.
template <int parts>
double farthest(const LeafMesh& from, const LeafMesh& to) {
    const SurfaceDistance distance(to.triangles, to.positions);
    double result = 0;
    Index nearest = 0;
    for (const Triangle& triangle : from.triangles) {
        const std::array<glm::dvec3, 3> p = {from.positions[triangle[0]], from.positions[triangle[1]],
                                             from.positions[triangle[2]]};
        for (const glm::dvec3& corner : p) result = std::max(result, distance(corner, nearest, result));
        for (const glm::dvec3& b : barycentric_grid<parts>())
            result = std::max(result, distance(b.x * p[0] + b.y * p[1] + b.z * p[2], nearest, result));
    }
    return result;
}

/// The Hausdorff distance, sampled.
double measured_distance(const Hierarchy& a, const Hierarchy& b) {
    const LeafMesh one = leaf_mesh(a), other = leaf_mesh(b);
    return std::max(farthest<3>(one, other), farthest<6>(other, one));
}

}  // namespace

TEST_CASE("a sphere is finer at its silhouette and near the camera, and coarse behind") {
    const Hierarchy sphere = make_key(*find_shape("sphere"), {20000, {}});
    const KeyDetail detail = measure_detail(sphere);
    const std::vector<float> weights = {1};
    ViewRefinement refinement({&sphere}, {&detail});
    ViewMesh mesh;
    // Mean area of the leaves by the angle of their place from the direction to the eye.
    const auto mean_area = [&](double from_degrees, double to_degrees) {
        double area = 0, count = 0;
        for (const Triangle& leaf : mesh.mesh.triangles) {
            const glm::dvec3 a = mesh.positions[leaf[0]], b = mesh.positions[leaf[1]],
                             c = mesh.positions[leaf[2]];
            const double angle = glm::degrees(std::acos(glm::normalize(a + b + c).z));
            if (angle < from_degrees || angle >= to_degrees) continue;
            area += glm::length(glm::cross(b - a, c - a)) / 2;
            ++count;
        }
        REQUIRE(count > 0);
        return area / count;
    };
    // From far away the silhouette is at 90 degrees.
    view_mesh(refinement.refine(weights, {.eye = {0, 0, 50}, .forward = {0, 0, -1}, .cosine = 0.99F}, 2000),
              refinement.keys(), weights, mesh);
    CHECK(2 * mean_area(80, 95) < mean_area(0, 30));
    CHECK(1.5 * mean_area(0, 30) < mean_area(150, 180));
    // From near the surface, what is outside the picture is coarse.
    view_mesh(refinement.refine(weights, {.eye = {0, 0, 1.3F}, .forward = {0, 0, -1}, .cosine = 0.85F}, 2000),
              refinement.keys(), weights, mesh);
    CHECK(5 * mean_area(0, 20) < mean_area(100, 180));
}

TEST_CASE("the measured distance of 200 cuts of ten keys is at most the threshold, and all cuts are sound") {
    constexpr std::uint64_t seed = 20260617;
    MESSAGE("seed " << seed);
    Random random(seed);
    std::vector<Hierarchy> keys;
    for (const char* shape : {"bone", "cushion", "star", "sphere", "brezel"})
        keys.push_back(make_key(*find_shape(shape), {500, {}}));
    for (unsigned n = 0; n < 5; ++n)
        keys.push_back(bisected_key(random_surface(n % 4, n % 2 == 1, random), random));
    double largest = 0, sum = 0;
    unsigned count = 0;
    for (unsigned n = 0; n < trials(200); ++n) {
        const Hierarchy& key = keys[n % keys.size()];
        CAPTURE(n);
        const std::vector<float> errors = vertex_errors(key);
        const CutSizes sizes(key, errors);
        // From a fiftieth of the largest error up to it; all ratios are equally likely.
        const auto top = static_cast<double>(sizes.distance(std::numeric_limits<float>::infinity()));
        const auto threshold = static_cast<float>(top * std::pow(0.02, random.unit()));
        CAPTURE(threshold);
        const Hierarchy coarse = cut(key, errors, threshold);
        REQUIRE(check(coarse) == std::vector<std::string>{});
        const double bound = sizes.distance(threshold);
        const double distance = measured_distance(coarse, key);
        REQUIRE(distance <= 1.00001 * bound + 1e-12);
        if (bound > 0) {
            largest = std::max(largest, distance / static_cast<double>(threshold));
            sum += distance / bound;
            ++count;
        }
    }
    MESSAGE("measured distance by threshold: at most " << largest << "; by bound: " << sum / count
                                                       << " in the mean");
}

TEST_CASE("on the sphere a cut has at most a tenth more leaves than a greedy refinement to equal distance") {
    const Hierarchy key = make_key(*find_shape("sphere"), {20000, {}});
    const std::vector<float> errors = vertex_errors(key);
    const CutSizes sizes(key, errors);
    const std::vector<glm::vec3> corners(key.positions.begin(),
                                         key.positions.begin() + key.roots.vertex_count());
    // The distance of the sphere from a triangle with corners on it.
    const auto distance = [](const AdaptiveMesh& mesh, Index leaf) {
        const auto& [a, b, c] = mesh.vertices(leaf);
        const auto p = mesh.positions();
        return 1 - std::sqrt(squared_distance_to_triangle(glm::dvec3(0), {p[a], p[b], p[c]}));
    };
    double worst = 0;
    for (int n = 0; n <= 40; ++n) {
        const double threshold = 0.2 * std::pow(0.01, n / 40.0);
        AdaptiveMesh* self = nullptr;
        AdaptiveMesh greedy(key.roots, corners, [&](Index a, Index b, Index) {
            return glm::normalize(self->positions()[a] + self->positions()[b]);
        });
        self = &greedy;
        refine_greedily(greedy, distance, {.tolerance = threshold});
        const auto leaves = static_cast<double>(sizes.leaf_count(static_cast<float>(threshold)));
        CAPTURE(threshold);
        CAPTURE(greedy.leaf_count());
        CHECK(leaves <= 1.1 * greedy.leaf_count());
        worst = std::max(worst, leaves / greedy.leaf_count());
    }
    MESSAGE("leaves by those of the greedy refinement: at most " << worst);
}
