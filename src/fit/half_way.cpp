#include "fit/half_way.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include <fmt/core.h>
#include <glm/vec3.hpp>

#include "fit/mesh/space_triangle.h"
#include "hierarchy/union_mesh.h"

namespace interleaf {
namespace {

double whole_area(std::span<const Triangle> triangles, std::span<const glm::dvec3> positions) {
    double area = 0;
    for (const auto& [a, b, c] : triangles)
        area += doubled_area({positions[a], positions[b], positions[c]}) / 2;
    return area;
}

}  // namespace

double half_way_area(const Hierarchy& key, const Hierarchy& other, const glm::dmat3& turn) {
    const std::array<const Hierarchy*, 2> keys = {&key, &other};
    const UnionMesh both = unite(keys);
    const std::vector<Triangle> triangles(both.triangles.begin(), both.triangles.end());
    std::vector<glm::dvec3> first(both.positions[0].begin(), both.positions[0].end());
    std::vector<glm::dvec3> second(both.positions[1].begin(), both.positions[1].end());
    const double first_scale = 1 / std::sqrt(whole_area(triangles, first));
    const double second_scale = 1 / std::sqrt(whole_area(triangles, second));
    for (std::size_t v = 0; v < first.size(); ++v)
        first[v] = (first_scale * first[v] + second_scale * (turn * second[v])) / 2.0;
    return whole_area(triangles, first);
}

std::string fault_of_half_way(double matched, double unmatched) {
    constexpr double margin = 0.005;
    if (matched > unmatched - margin) return {};
    return fmt::format("half way, the surface keeps {:.3f} of the area, {:.3f} without matching", matched,
                       unmatched);
}

}  // namespace interleaf
