#include "fit/star_shapes.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "fit/closed_meshes.h"

namespace interleaf::testing {

MappedMesh star_shape(unsigned divisions, const std::function<double(const glm::dvec3&)>& radius) {
    MappedMesh mapped{icosphere(divisions), {}};
    for (glm::dvec3& position : mapped.mesh.positions) {
        mapped.points.push_back(glm::normalize(position));
        position = radius(mapped.points.back()) * mapped.points.back();
    }
    return mapped;
}

MappedMesh unit_sphere_mesh(unsigned divisions) {
    return star_shape(divisions, [](const glm::dvec3&) { return 1.0; });
}

MappedMesh bumpy_ellipsoid(unsigned divisions) {
    return star_shape(divisions, [](const glm::dvec3& u) {
        const double ellipsoid = 1 / glm::length(u / glm::dvec3(1, 1.5, 2));
        return ellipsoid * (1 + 0.03 * std::sin(9 * u.x) * std::sin(7 * u.y + 1) * std::sin(8 * u.z));
    });
}

MappedMesh ball_with_spike(unsigned divisions) {
    MappedMesh mapped = unit_sphere_mesh(divisions);
    const auto top = std::max_element(mapped.points.begin(), mapped.points.end(),
                                      [](const auto& p, const auto& q) { return p.z < q.z; });
    mapped.mesh.positions[static_cast<std::size_t>(top - mapped.points.begin())] = {0, 0, 3};
    return mapped;
}

MappedMesh six_arms(unsigned divisions) {
    return star_shape(divisions, [](const glm::dvec3& u) {
        return 1 + 3 * (std::pow(u.x, 20) + std::pow(u.y, 20) + std::pow(u.z, 20));
    });
}

}  // namespace interleaf::testing
