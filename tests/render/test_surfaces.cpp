// Builds the surfaces.
#include "render/test_surfaces.h"

#include <doctest/doctest.h>
#include <glm/common.hpp>

#include "hierarchy/adaptive_mesh.h"
#include "shapes/shapes.h"

namespace interleaf {

TestSurface surface_of(const std::vector<Hierarchy>& keys) {
    std::vector<const Hierarchy*> pointers;
    pointers.reserve(keys.size());
    for (const Hierarchy& key : keys) pointers.push_back(&key);
    TestSurface surface{unite(pointers), {}};
    surface.form = normal_form(surface.mesh);
    return surface;
}

TestSurface surface_of_shapes(std::initializer_list<std::string_view> names, Index leaves) {
    std::vector<Hierarchy> keys;
    for (const std::string_view name : names) {
        const Shape* shape = find_shape(name);
        REQUIRE(shape != nullptr);
        ShapeBudget budget;
        budget.leaves = leaves;
        keys.push_back(make_key(*shape, budget));
    }
    return surface_of(keys);
}

std::vector<Hierarchy> two_keys_of_a_square() {
    // Vertex 1 is right of the diagonal from 0 to 2, vertex 3 left of it.
    const RootComplex roots(4, {{{1, 2, 0}, {3, 0, 2}}});
    const std::vector<glm::vec3> positions = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
    AdaptiveMesh bisected(roots, positions);
    const Index right = 0;
    bisected.refine({&right, 1});  // the diagonal, so both roots
    bisected.refine({&right, 1});  // a side of the square
    return {bisected.freeze(), unrefined(roots, positions)};
}

Camera camera_on(const TestSurface& surface, const OffscreenTarget& target, float azimuth, float elevation) {
    Box box = bounding_box(surface.mesh.positions.front());
    for (const auto& stream : surface.mesh.positions) {
        const Box other = bounding_box(stream);
        box = {glm::min(box.min, other.min), glm::max(box.max, other.max)};
    }
    Camera camera;
    camera.look_from(azimuth, elevation);
    camera.view_all(extent_of(box), static_cast<float>(target.width()) / static_cast<float>(target.height()));
    return camera;
}

}  // namespace interleaf
