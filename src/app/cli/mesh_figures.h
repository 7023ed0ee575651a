// What `interleaf info` and `interleaf check` say of a mesh.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "fit/clean_up/surface_census.h"

namespace interleaf {

struct MeshFigures {
    SurfaceCensus census;
    double min_angle = 0;   ///< degrees
    glm::dvec3 box_min{0};  ///< of the vertices in use
    glm::dvec3 box_max{0};
    bool has_colors = false;
    std::uintmax_t file = 0;           ///< bytes
    std::vector<std::string> remarks;  ///< sentences about how it was read
};

/// \throw InputError, MachineError as read_surface()
MeshFigures figures_of_mesh(const std::filesystem::path& file);

/// What keeps a mesh from being fitted as it is, a sentence each; none where nothing does.
/// \throw InputError, MachineError as read_surface()
std::vector<std::string> faults_of_mesh(const std::filesystem::path& file);

/// "4, closed, without handles" or "1, with 3 openings and 2 handles".
std::string in_words(const SurfaceCensus& census);

}  // namespace interleaf
