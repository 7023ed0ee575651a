#include "fit/sampling/mapped_surface.h"

namespace interleaf {

MappedSurface::MappedSurface(const SurfaceMesh& surface, std::span<const glm::dvec3> map)
    : mesh(surface), points(map), location(mesh.triangles, points), distance(mesh.triangles, mesh.positions) {
    normals.reserve(mesh.triangles.size());
    for (const auto& [a, b, c] : mesh.triangles)
        normals.push_back(unit_normal({mesh.positions[a], mesh.positions[b], mesh.positions[c]}));
}

}  // namespace interleaf
