// `interleaf fit`: keys from meshes.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/fitting/axis_turn.h"
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
    std::vector<AxisTurn> rotations;  ///< none, or one a mesh
    std::vector<UpAxis> ups;          ///< none, or one a mesh
    PlacingOptions placing;
    bool keep_largest = false;  ///< of several parts
    bool fill_holes = false;    ///< however large
    bool json = false;          ///< the report, on standard output
    HierarchyFileOptions form;
};

/// Writes the key of one mesh, or the family of several: its timeline goes through them, its domain, when
/// there are three, is a triangle of them. Prints what was done with each mesh, and how good its key is, on
/// standard output, unless the key goes there. \throw InputError, UsageError, MachineError
void run_fit(const FitCommandOptions& options);

}  // namespace interleaf
