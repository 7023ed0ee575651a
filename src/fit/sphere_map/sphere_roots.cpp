#include "fit/sphere_map/sphere_roots.h"

#include <fmt/core.h>
#include <glm/geometric.hpp>

#include "fit/mesh/surface_mesh.h"
#include "fit/sphere_map/spherical_map.h"
#include "hierarchy/error.h"
#include "hierarchy/measure.h"

namespace interleaf {

Hierarchy octahedron() {
    const std::vector<glm::vec3> corners = {{1, 0, 0},  {0, 1, 0}, {-1, 0, 0},
                                            {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    std::vector<Triangle> triangles = {{4, 0, 1}, {4, 1, 2}, {4, 2, 3}, {4, 3, 0},
                                       {5, 1, 0}, {5, 2, 1}, {5, 3, 2}, {5, 0, 3}};
    return unrefined(RootComplex(6, std::move(triangles)), corners);
}

SphereRoots project_to_sphere(const Hierarchy& hierarchy) {
    const RootComplex& complex = hierarchy.roots;
    if (complex.boundary_edge_count() > 0 || complex.euler_number() != 2)
        throw InputError(
            fmt::format("the roots have {} boundary edges and Euler number {}, expected a closed surface "
                        "with Euler number 2",
                        complex.boundary_edge_count(), complex.euler_number()));

    const auto corners = std::span(hierarchy.positions).first(complex.vertex_count());
    const glm::dvec3 center = bounding_box(corners).center();
    SurfaceMesh mesh;
    SphereRoots roots{complex, {}};
    for (const glm::dvec3 corner : corners) {
        const double length = glm::distance(corner, center);
        if (!(length > 0))
            throw InputError("a root vertex lies in the middle of the roots' box, expected none there");
        roots.points.push_back((corner - center) / length);
        mesh.positions.push_back(corner);
    }
    mesh.triangles.assign(complex.triangles().begin(), complex.triangles().end());
    if (const std::string fault = fault_of_map(mesh, roots.points); !fault.empty())
        throw InputError(fmt::format(
            "the roots, seen from the middle of their box, do not cover each direction once: {}", fault));
    return roots;
}

}  // namespace interleaf
