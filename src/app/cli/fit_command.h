// `interleaf fit`: makes keys from meshes.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/fitting/axis_turn.h"
#include "fit/landmarks/landmark_targets.h"
#include "fit/placement.h"
#include "hierarchy/triangle.h"
#include "io/hierarchy/hierarchy_file.h"

namespace interleaf {

struct FitCommandOptions {
    std::vector<std::filesystem::path> meshes;
    std::string output;  ///< an .ilh file or "-" for one mesh, a folder for several
    std::optional<Index> leaves;
    std::optional<double> tolerance;
    std::string roots = "cube";       ///< "cube", "icosahedron", "octahedron" or an .obj file
    std::vector<AxisTurn> rotations;  ///< empty, or one per mesh
    std::vector<UpAxis> ups;          ///< empty, or one per mesh
    PlacingOptions placing;
    bool matches = true;  ///< matches the maps of all meshes but the first to that of the first
    std::vector<std::filesystem::path> landmarks;  ///< empty, or one file per mesh
    std::optional<LandmarkPlacing> landmark_placing;
    std::string onto;           ///< a family whose landmarks and roots the keys get; empty for none
    bool keep_largest = false;  ///< keeps only the largest of several parts
    bool fill_holes = false;    ///< fills holes of any size
    bool json = false;          ///< prints the report as JSON
    HierarchyFileOptions form;
};

/// Writes the key of one mesh, or the family of several meshes. The timeline of the family passes through all
/// keys. A family of three keys has a domain, the triangle of its keys. Prints on standard output what was
/// done with each mesh, and the quality of its key, unless the key is written there.
/// \throw InputError, UsageError, MachineError
void run_fit(const FitCommandOptions& options);

}  // namespace interleaf
