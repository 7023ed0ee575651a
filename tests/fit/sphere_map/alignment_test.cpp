// Alignment finds the rotation by which a map is turned.
#include "fit/sphere_map/alignment.h"

#include <random>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "fit/star_shapes.h"

using namespace interleaf;
using namespace interleaf::testing;

TEST_CASE("a map that was turned is turned back, wherever the surface lies") {
    const MappedMesh mapped = bumpy_ellipsoid(3);
    SurfaceMesh mesh = mapped.mesh;
    for (glm::dvec3& position : mesh.positions) position = 50.0 * position + glm::dvec3(1000, -200, 30);

    std::vector<glm::dvec3> best = mapped.points;
    rotate(best, rotation_to_surface(mesh, best));
    const double cosine = mean_cosine(mesh, best);
    CHECK(cosine > 0.95);

    std::mt19937 random(2);
    std::uniform_real_distribution<double> any(-1, 1);
    for (int trial = 0; trial < 20; ++trial) {
        const glm::dvec3 axis(any(random), any(random), any(random));
        const glm::dmat3 turn(glm::rotate(glm::dmat4(1), 3.2 * any(random), glm::normalize(axis)));
        std::vector<glm::dvec3> points = mapped.points;
        rotate(points, turn);
        CHECK(mean_cosine(mesh, points) < cosine + 1e-12);
        rotate(points, rotation_to_surface(mesh, points));
        CHECK(mean_cosine(mesh, points) == doctest::Approx(cosine).epsilon(1e-12));
        double farthest = 0;
        for (std::size_t v = 0; v < points.size(); ++v)
            farthest = std::max(farthest, glm::distance(points[v], best[v]));
        CHECK(farthest < 1e-9);
    }
}

TEST_CASE("half a turn, and a map that is best as it is, are no trouble") {
    const MappedMesh mapped = unit_sphere_mesh(2);
    std::vector<glm::dvec3> points = mapped.points;
    rotate(points, glm::dmat3(-1, 0, 0, 0, -1, 0, 0, 0, 1));
    rotate(points, rotation_to_surface(mapped.mesh, points));
    CHECK(mean_cosine(mapped.mesh, points) == doctest::Approx(1));
    rotate(points, rotation_to_surface(mapped.mesh, points));
    CHECK(mean_cosine(mapped.mesh, points) == doctest::Approx(1));
}
