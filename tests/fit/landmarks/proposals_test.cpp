// The extremities of bodies that have known ones.
#include "fit/landmarks/proposals.h"

#include <algorithm>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "fit/mesh/surface_graph.h"
#include "fit/star_shapes.h"
#include "hierarchy/progress.h"

using namespace interleaf;
using namespace interleaf::testing;

TEST_CASE("the tips of six arms are proposed, and no other point") {
    const MappedMesh body = six_arms(4);
    const std::vector<Extremity> found = find_extremities(body.mesh, {}, {});
    REQUIRE(found.size() == 6);
    CHECK(found[0].persistence == 1);
    for (int axis = 0; axis < 3; ++axis)
        for (const double sign : {-1.0, 1.0}) {
            glm::dvec3 tip(0);
            tip[axis] = sign;
            CHECK(std::ranges::any_of(found, [&](const Extremity& each) {
                return glm::distance(body.points[each.vertex], tip) < 0.15;
            }));
        }
    CHECK(find_extremities(body.mesh, {.max_count = 2}, {}).size() == 2);
}

TEST_CASE("a spike is the first extremity of a ball") {
    const MappedMesh body = ball_with_spike(3);
    const std::vector<Extremity> found = find_extremities(body.mesh, {}, {});
    REQUIRE_FALSE(found.empty());
    CHECK(body.mesh.positions[found[0].vertex] == glm::dvec3(0, 0, 3));
    CHECK_THROWS_AS(find_extremities(body.mesh, {}, [](std::string_view, double part) { return part < 0.5; }),
                    Cancelled);
}

TEST_CASE("distances along a sphere are a few percent longer than great circles at most") {
    const MappedMesh ball = unit_sphere_mesh(4);
    const std::vector<double> distances =
        SurfaceGraph(ball.mesh.triangles, ball.mesh.positions).distances_from(7);
    for (std::size_t v = 0; v < distances.size(); ++v) {
        const double arc = std::acos(std::clamp(glm::dot(ball.points[v], ball.points[7]), -1.0, 1.0));
        CHECK(distances[v] >= 0.995 * arc);
        CHECK(distances[v] <= 1.06 * arc + 1e-12);
    }
}
