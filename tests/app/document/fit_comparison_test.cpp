// Tests of the comparison of a fitted key with its mesh.
#include "app/document/fit_comparison.h"

#include <cmath>

#include <doctest/doctest.h>

#include "fit/sphere_map/sphere_roots.h"
#include "hierarchy/error.h"
#include "hierarchy/progress.h"

using namespace interleaf;

namespace {

/// An octahedron as a key of one that is larger by \p factor.
FittedKey octahedron_in_larger(double factor) {
    FittedKey fitted;
    fitted.hierarchy = octahedron();
    for (const glm::vec3& position : fitted.hierarchy.positions)
        fitted.mesh.positions.push_back(factor * glm::dvec3(position));
    const auto triangles = fitted.hierarchy.roots.triangles();
    fitted.mesh.triangles.assign(triangles.begin(), triangles.end());
    fitted.report.quality.hausdorff = 0.25;
    return fitted;
}

}  // namespace

TEST_CASE("distances are in percent of the box diagonal, from the mesh to the key and back") {
    const FitComparison comparison = compare("octahedron.off", octahedron_in_larger(1.1));
    CHECK(comparison.mesh_name == "octahedron.off");
    CHECK(comparison.positions.size() == 6);
    CHECK(comparison.triangles.size() == 8);
    CHECK(comparison.quality.hausdorff == 0.25);
    const double diagonal = 2 * 1.1 * std::sqrt(3.0);
    // A tip of the larger octahedron is nearest to a tip; all points of the smaller one are nearest to the
    // planes of the larger one's faces.
    for (const float distance : comparison.mesh_distances)
        CHECK(distance == doctest::Approx(100 * 0.1 / diagonal));
    for (const float distance : comparison.key_distances)
        CHECK(distance == doctest::Approx(100 * 0.1 / std::sqrt(3.0) / diagonal));
    CHECK(max_distance(comparison) == comparison.mesh_distances.front());
}

TEST_CASE("a key whose vertices lie on its mesh is measured between them, too") {
    FittedKey fitted = octahedron_in_larger(1);
    // The mesh gets a tip over the middle of its first face.
    const Triangle face = fitted.mesh.triangles.front();
    glm::dvec3 middle(0);
    for (const Index vertex : face) middle += fitted.mesh.positions[vertex] / 3.0;
    fitted.mesh.positions.push_back(1.5 * middle);
    fitted.mesh.triangles.front() = {face[0], face[1], 6};
    fitted.mesh.triangles.push_back({face[1], face[2], 6});
    fitted.mesh.triangles.push_back({face[2], face[0], 6});
    const FitComparison comparison = compare("tip.off", std::move(fitted));
    for (Index vertex = 0; vertex < 6; ++vertex) {
        const bool is_of_face = vertex == face[0] || vertex == face[1] || vertex == face[2];
        CHECK((comparison.key_distances[vertex] > 1) == is_of_face);
        CHECK(comparison.mesh_distances[vertex] == doctest::Approx(0));
    }
    CHECK(comparison.mesh_distances[6] > comparison.key_distances[face[0]]);
}

TEST_CASE("comparing can be cancelled") {
    CHECK_THROWS_AS(
        compare("octahedron.off", octahedron_in_larger(1.1), [](std::string_view, double) { return false; }),
        Cancelled);
}

TEST_CASE("a comparison goes with the hierarchy, whatever its key is called and wherever it is") {
    auto comparison = std::make_shared<const FitComparison>(compare("a.off", octahedron_in_larger(1.1)));
    Family family{.name = "f", .keys = {{"other", octahedron()}}, .timeline = {}, .domain = {}};
    CHECK(compared_keys(family, {comparison}).empty());
    family.keys.push_back({"renamed", comparison->key});
    const auto compared = compared_keys(family, {comparison});
    REQUIRE(compared.size() == 1);
    CHECK(compared.front().key == 1);
    CHECK(compared.front().comparison == comparison);
    CHECK(compared_keys(family, {}).empty());
}

TEST_CASE("the quality of a fit is said in a sentence") {
    FitQuality quality;
    quality.hausdorff = 0.001234;
    quality.min_angle = 11.234;
    CHECK(in_words(quality) ==
          "at most 0.123 % of the box diagonal from the mesh, least angle 11.2 degrees, no flipped leaves");
    quality.flipped_leaves = 1;
    CHECK(in_words(quality).ends_with(", 1 flipped leaf"));
    quality.flipped_leaves = 7;
    CHECK(in_words(quality).ends_with(", 7 flipped leaves"));
}
