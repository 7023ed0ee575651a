// Figures of a field are those of the piecewise linear function.
#include "family/field_figures.h"

#include <doctest/doctest.h>

#include "hierarchy/adaptive_mesh.h"

using namespace interleaf;

TEST_CASE("a bisection does not change the figures of a linear field") {
    const RootComplex roots(4, {{0, 1, 2}, {3, 2, 1}});
    const std::vector<glm::vec3> corners = {{0, 0, 0}, {2, 0, 0}, {0, 3, 0}, {2, 3, 0}};
    AdaptiveMesh mesh(roots, corners);
    for (int round = 0; round < 4; ++round) {
        Hierarchy key = mesh.freeze();
        key.fields = {{"u", FieldKind::scalar, {}}};
        for (const glm::vec3& position : key.positions)
            key.fields[0].values.push_back(position.x - position.y);
        const FieldFigures figures = figures_of(key, key.fields[0]);
        CHECK(figures.integral == doctest::Approx(6 * (1 - 1.5)));
        CHECK(figures.least == -3);
        CHECK(figures.most == 2);
        mesh.refine({{Index{0}}});
    }
}
