#include "app/importing/point_motion.h"

#include <array>
#include <vector>

#include <glm/geometric.hpp>

#include "fit/mesh/surface_distance.h"
#include "fit/mesh/surface_mesh.h"
#include "hierarchy/measure.h"
#include "hierarchy/union_mesh.h"

namespace interleaf {

PointMotion motion_of_points(const Hierarchy& from, const Hierarchy& to) {
    const std::array<const Hierarchy*, 2> keys = {&from, &to};
    const UnionMesh mesh = unite(keys);
    std::vector<double> areas(mesh.vertex_count(), 0);
    for (const auto& [a, b, c] : mesh.triangles) {
        const glm::dvec3 corner(mesh.positions[0][a]);
        const double area = glm::length(
            glm::cross(glm::dvec3(mesh.positions[0][b]) - corner, glm::dvec3(mesh.positions[0][c]) - corner));
        for (const Index vertex : {a, b, c}) areas[vertex] += area;
    }
    const SurfaceMesh surface = surface_of(to);
    const SurfaceDistance distance(surface.triangles, surface.positions);
    PointMotion sum;
    double area = 0;
    Index nearest = no_index;
    for (std::size_t v = 0; v < areas.size(); ++v) {
        const glm::dvec3 place(mesh.positions[0][v]);
        sum.points += areas[v] * glm::distance(place, glm::dvec3(mesh.positions[1][v]));
        sum.surface += areas[v] * distance(place, nearest);
        area += areas[v];
    }
    const Box box = bounding_box(from.positions);
    const double whole = area * glm::distance(glm::dvec3(box.min), glm::dvec3(box.max));
    if (!(whole > 0)) return {};
    return {sum.points / whole, sum.surface / whole};
}

}  // namespace interleaf
