#include "fit/sampling/mapped_surface.h"

namespace interleaf {

MappedSurface::MappedSurface(const SurfaceMesh& surface, std::span<const glm::dvec3> map,
                             std::span<const glm::dvec3> landmark_positions)
    : mesh(surface), points(map), location(mesh.triangles, points), distance(mesh.triangles, mesh.positions) {
    normals.reserve(mesh.triangles.size());
    for (const auto& [a, b, c] : mesh.triangles)
        normals.push_back(unit_normal({mesh.positions[a], mesh.positions[b], mesh.positions[c]}));
    landmarks.reserve(landmark_positions.size());
    for (const glm::dvec3& landmark : landmark_positions) {
        const MeshPoint point = nearest_point(landmark);
        landmarks.push_back({direction(point), position(point)});
    }
}

MeshPoint MappedSurface::nearest_point(const glm::dvec3& place) const {
    MeshPoint point;
    distance(place, point.triangle);
    const auto& [a, b, c] = mesh.triangles[point.triangle];
    point.barycentric = nearest_place(place, {mesh.positions[a], mesh.positions[b], mesh.positions[c]});
    return point;
}

}  // namespace interleaf
