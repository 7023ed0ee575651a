#pragma once

#include <string>
#include <vector>

#include "fit/progress.h"
#include "fit/surface_mesh.h"

namespace interleaf {
struct CleanUpReport {
    std::vector<std::string> words;
};
struct CleanMesh {
    SurfaceMesh mesh;
    CleanUpReport report;
    std::vector<Index> source_vertex;
};
CleanMesh clean_up(SurfaceMesh mesh, const Progress& progress);
}  // namespace interleaf
