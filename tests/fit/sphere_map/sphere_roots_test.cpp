// Roots over the sphere: the built-in roots are sound, and roots that do not cover the sphere once are
// refused.
#include "fit/sphere_map/sphere_roots.h"

#include <string>

#include "messages.h"
#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "fit/closed_meshes.h"
#include "hierarchy/cube.h"
#include "hierarchy/error.h"
#include "hierarchy/marking.h"
#include "hierarchy/measure.h"

using namespace interleaf;
using namespace interleaf::testing;

namespace {

Hierarchy as_roots(const SurfaceMesh& mesh) {
    std::vector<glm::vec3> positions(mesh.positions.begin(), mesh.positions.end());
    return unrefined(RootComplex(static_cast<Index>(positions.size()), mesh.triangles), positions);
}

std::string refusal(const Hierarchy& roots) {
    try {
        project_to_sphere(roots);
    } catch (const InputError& error) {
        return error.what();
    }
    return {};
}

}  // namespace

TEST_CASE("cube and octahedron are closed, look outward and are marked compatibly on their longest edges") {
    for (const Hierarchy& roots : {cube(), octahedron()}) {
        CAPTURE(roots.roots.triangle_count());
        CHECK(roots.roots.euler_number() == 2);
        CHECK(roots.roots.boundary_edge_count() == 0);
        CHECK(measure(roots.roots.triangles(), roots.positions).volume > 0);
        CHECK(is_compatibly_marked(roots.roots));
        for (const auto& [a, b, c] : roots.roots.triangles()) {
            const float refinement = glm::distance(roots.positions[b], roots.positions[c]);
            CHECK(refinement >= glm::distance(roots.positions[a], roots.positions[b]));
            CHECK(refinement >= glm::distance(roots.positions[c], roots.positions[a]));
        }
        const SphereRoots projected = project_to_sphere(roots);
        CHECK(projected.complex == roots.roots);
        for (const glm::dvec3& point : projected.points) CHECK(glm::length(point) == doctest::Approx(1));
    }
}

TEST_CASE("roots are projected from the middle of their box, wherever they lie") {
    Hierarchy roots = cube();
    const SphereRoots before = project_to_sphere(roots);
    for (glm::vec3& position : roots.positions) position = position * 4.0F + glm::vec3(100, 0, -50);
    const SphereRoots after = project_to_sphere(roots);
    for (std::size_t v = 0; v < before.points.size(); ++v)
        CHECK(glm::distance(before.points[v], after.points[v]) < 1e-6);
}

TEST_CASE("roots that do not cover the sphere once are refused with the reason") {
    CHECK(contains(refusal(as_roots(torus(8, 6))), "Euler number 0"));
    CHECK(contains(refusal(as_roots(sheet(2))), "boundary edges"));
    Hierarchy dented = as_roots(icosphere(1));
    dented.positions[0] *= -1.0F;
    CHECK(contains(refusal(dented), "do not cover"));
    Hierarchy inward = cube();
    for (glm::vec3& position : inward.positions) position.x *= -1;
    CHECK(contains(refusal(inward), "do not cover"));
    Hierarchy pierced = as_roots(icosphere(2));
    pierced.positions[0] = {0, 0, 0};
    CHECK_FALSE(refusal(pierced).empty());
}
