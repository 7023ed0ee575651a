#include "fit/sampling/sampled_fields.h"

#include <cstddef>
#include <span>

#include <glm/common.hpp>

#include "fit/mesh/space_triangle.h"
#include "fit/mesh/surface_distance.h"

namespace interleaf {
namespace {

/// The place on \p mesh of each vertex of \p surface.
std::vector<MeshPoint> places_on_mesh(const SurfaceMesh& mesh, const MappedSurface& mapped,
                                      const SampledSurface& surface) {
    if (&mapped.mesh == &mesh) return surface.mesh_points;
    // The finer mesh has flipped edges of the mesh, so values between vertices would differ.
    const SurfaceDistance distance(mesh.triangles, mesh.positions);
    std::vector<MeshPoint> places;
    places.reserve(surface.mesh_points.size());
    Index nearest = no_index;
    for (const MeshPoint& point : surface.mesh_points) {
        const glm::dvec3 position = mapped.position(point);
        distance(position, nearest);
        const auto& [a, b, c] = mesh.triangles[nearest];
        places.push_back(
            {nearest, nearest_place(position, TriangleCorners{mesh.positions[a], mesh.positions[b],
                                                              mesh.positions[c]})});
    }
    return places;
}

Field sampled_color(const SurfaceMesh& mesh, std::span<const MeshPoint> places) {
    Field field{"color", FieldKind::color, {}};
    field.values.reserve(3 * places.size());
    for (const MeshPoint& place : places) {
        const glm::vec3 value = place.of(std::span(mesh.triangles), std::span(mesh.colors));
        const glm::vec3 color = glm::clamp(value, 0.0F, 1.0F);
        field.values.insert(field.values.end(), {color.r, color.g, color.b});
    }
    return field;
}

Field sampled_scalar(const SurfaceMesh& mesh, const MeshField& scalar, std::span<const MeshPoint> places) {
    Field field{scalar.name, FieldKind::scalar, {}};
    field.values.reserve(places.size());
    for (const MeshPoint& place : places) {
        double value = 0;
        for (std::size_t k = 0; k < 3; ++k)
            value +=
                place.barycentric[static_cast<int>(k)] * scalar.values[mesh.triangles[place.triangle][k]];
        field.values.push_back(static_cast<float>(value));
    }
    return field;
}

}  // namespace

std::vector<Field> sampled_fields(const SurfaceMesh& mesh, const MappedSurface& mapped,
                                  const SampledSurface& surface) {
    std::vector<Field> fields;
    if (mesh.colors.empty() && mesh.scalars.empty()) return fields;
    const std::vector<MeshPoint> places = places_on_mesh(mesh, mapped, surface);
    fields.reserve(mesh.scalars.size() + 1);
    if (!mesh.colors.empty()) fields.push_back(sampled_color(mesh, places));
    for (const MeshField& scalar : mesh.scalars)
        if (fields.empty() || scalar.name != fields.front().name)
            fields.push_back(sampled_scalar(mesh, scalar, places));
    return fields;
}

}  // namespace interleaf
