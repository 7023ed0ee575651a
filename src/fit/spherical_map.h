#pragma once

#include <span>
#include <string>
#include <vector>

#include "fit/progress.h"
#include "fit/surface_mesh.h"

namespace interleaf {
struct SphericalMap {
    std::vector<glm::dvec3> points;
};
SphericalMap map_to_sphere(const SurfaceMesh& mesh, const Progress& progress);
std::string fault_of_map(const SurfaceMesh& mesh, std::span<const glm::dvec3> points);
void center_map(const SurfaceMesh& mesh, std::vector<glm::dvec3>& points);
}  // namespace interleaf
