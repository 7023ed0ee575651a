#include "fit/sampling/sampled_colors.h"

#include <span>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "fit/mesh/surface_distance.h"

namespace interleaf {
namespace {

/// The color of the triangle mesh at a place on it.
glm::vec3 color_at(const SurfaceMesh& mesh, const SurfaceDistance& distance, const glm::dvec3& place,
                   Index& nearest) {
    distance(place, nearest);
    const auto& [a, b, c] = mesh.triangles[nearest];
    const glm::dvec3 ab = mesh.positions[b] - mesh.positions[a];
    const glm::dvec3 ac = mesh.positions[c] - mesh.positions[a];
    const glm::dvec3 normal = glm::cross(ab, ac);
    const double squared = glm::dot(normal, normal);
    const glm::dvec3 from_a = place - mesh.positions[a];
    const double at_b = squared > 0 ? glm::dot(glm::cross(from_a, ac), normal) / squared : 0;
    const double at_c = squared > 0 ? glm::dot(glm::cross(ab, from_a), normal) / squared : 0;
    return static_cast<float>(1 - at_b - at_c) * mesh.colors[a] + static_cast<float>(at_b) * mesh.colors[b] +
           static_cast<float>(at_c) * mesh.colors[c];
}

}  // namespace

std::vector<Field> sampled_colors(const SurfaceMesh& mesh, const MappedSurface& mapped,
                                  const SampledSurface& surface) {
    if (mesh.colors.empty()) return {};
    Field field{"color", FieldKind::color, {}};
    field.values.reserve(3 * surface.mesh_points.size());
    const auto add = [&](const glm::vec3& value) {
        const glm::vec3 color = glm::clamp(value, 0.0F, 1.0F);
        field.values.insert(field.values.end(), {color.r, color.g, color.b});
    };
    if (&mapped.mesh == &mesh) {
        for (const MeshPoint& point : surface.mesh_points)
            add(point.of(std::span(mesh.triangles), std::span(mesh.colors)));
    } else {
        // The finer mesh has flipped edges of the mesh, so colors between vertices would differ.
        const SurfaceDistance distance(mesh.triangles, mesh.positions);
        Index nearest = no_index;
        for (const MeshPoint& point : surface.mesh_points)
            add(color_at(mesh, distance, mapped.position(point), nearest));
    }
    return {std::move(field)};
}

}  // namespace interleaf
