// The figures and faults of a mesh, which `interleaf info` and `interleaf check` print.
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
    std::vector<std::string> remarks;  ///< sentences about content that was read differently than written
};

/// \throw InputError, MachineError as read_surface()
MeshFigures figures_of_mesh(const std::filesystem::path& file);

/// The reasons why no key can be fitted to a mesh as it is, one sentence per reason; empty if there are none.
/// \throw InputError, MachineError as read_surface()
std::vector<std::string> faults_of_mesh(const std::filesystem::path& file);

/// The parts of a mesh in words: "4, closed, without handles" or "1, with 3 openings and 2 handles".
std::string in_words(const SurfaceCensus& census);

}  // namespace interleaf
