// Landmarks become vertices exactly at the nearest points, and the surface stays as it is.
#include "fit/landmarks/landmark_insertion.h"

#include <random>
#include <string>

#include "messages.h"
#include "thrown_errors.h"
#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "fit/mesh/half_edge_mesh.h"
#include "fit/placement.h"
#include "fit/star_shapes.h"

using namespace interleaf;
using namespace interleaf::testing;

namespace {

std::vector<Landmark> named(const std::vector<glm::dvec3>& positions) {
    std::vector<Landmark> landmarks;
    for (const glm::dvec3& position : positions)
        landmarks.push_back({std::to_string(landmarks.size()), position});
    return landmarks;
}

/// The closed surface with its landmarks has the area of \p before, its colors, and all its vertices.
void check_same_surface(const MeshWithLandmarks& after, const SurfaceMesh& before) {
    const HalfEdgeMesh closed(Index(after.mesh.positions.size()), after.mesh.triangles);
    CHECK(closed.is_connected());
    CHECK(after.mesh.triangles.size() == 2 * after.mesh.positions.size() - 4);
    CHECK(extent_of(after.mesh).size == doctest::Approx(extent_of(before).size).epsilon(1e-12));
    for (std::size_t v = 0; v < before.positions.size(); ++v)
        REQUIRE(after.mesh.positions[v] == before.positions[v]);
    CHECK(after.mesh.colors.size() == (before.colors.empty() ? 0 : after.mesh.positions.size()));
}

}  // namespace

TEST_CASE("points of triangles and of edges become vertices, also many in one triangle") {
    SurfaceMesh mesh = bumpy_ellipsoid(2).mesh;
    mesh.colors.assign(mesh.positions.size(), glm::vec3(0.25F, 0.5F, 0.75F));
    mesh.scalars = {{"x", 1, {}}};
    for (const glm::dvec3& position : mesh.positions) mesh.scalars.front().values.push_back(position.x);
    std::mt19937 random(1);
    std::uniform_real_distribution<double> part(0.05, 0.3);
    std::vector<glm::dvec3> points;
    for (std::size_t t = 0; t < 40; ++t) {
        const auto& [a, b, c] = mesh.triangles[t < 20 ? 0 : t];
        const double u = part(random);
        const double v = t % 3 == 2 ? 0 : part(random);  // every third point is on an edge
        points.push_back((1 - u - v) * mesh.positions[a] + u * mesh.positions[b] + v * mesh.positions[c]);
    }
    const MeshWithLandmarks made = insert_landmarks(mesh, named(points));
    check_same_surface(made, mesh);
    REQUIRE(made.mesh.scalars.front().values.size() == made.mesh.positions.size());
    for (std::size_t k = 0; k < points.size(); ++k) {
        CAPTURE(k);
        const Index vertex = made.vertices[k];
        CHECK(made.mesh.scalars.front().values[vertex] == doctest::Approx(made.mesh.positions[vertex].x));
        CHECK(glm::distance(made.mesh.positions[made.vertices[k]], points[k]) < 1e-3);
        CHECK(made.distances[k] < 1e-3);
    }
    CHECK(glm::distance(made.mesh.positions[made.vertices[0]], points[0]) < 1e-14);
    CHECK(made.mesh.colors.back().y == doctest::Approx(0.5));
}

TEST_CASE("vertices stay the vertices they are, and points off the surface move to it") {
    const SurfaceMesh mesh = unit_sphere_mesh(2).mesh;
    const MeshWithLandmarks made =
        insert_landmarks(mesh, named({mesh.positions[17], 3.0 * mesh.positions[4]}));
    CHECK(made.vertices == std::vector<Index>{17, 4});
    CHECK(made.mesh.positions.size() == mesh.positions.size());
    CHECK(made.distances[1] == doctest::Approx(2));
}

TEST_CASE("two landmarks at one point are refused by name") {
    const SurfaceMesh mesh = unit_sphere_mesh(2).mesh;
    const auto& [a, b, c] = mesh.triangles[5];
    const glm::dvec3 middle = (mesh.positions[a] + mesh.positions[b] + mesh.positions[c]) / 3.0;
    const std::string text = input_error_of([&] {
        insert_landmarks(mesh, std::vector<Landmark>{{"nose", middle}, {"ear", {5, 5, 5}}, {"tail", middle}});
    });
    CHECK(contains(text, "'nose' and 'tail' are at the same point"));
}
