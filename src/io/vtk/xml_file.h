// Reads the VTK XML formats of surfaces: .vtu (unstructured grids), .vtp (polygons), and .pvtu and .pvtp, which
// name files of pieces. Quadratic cells and volumes are refused by name.
#pragma once

#include <filesystem>
#include <string>

#include "hierarchy/field_mesh.h"

namespace interleaf {

/// Reads the content \p text of a .vtu or .vtp file. Messages call the file \p name.
///
/// Cells that another piece has as well, hidden cells, and arrays whose names begin with "vtk" are left out.
/// \throw InputError naming the file, the place and what was expected
FieldMesh parse_vtk_xml(std::string text, const std::string& name);

/// Reads a file of at most 4 GiB, and the files of its pieces.
/// \throw InputError   as parse_vtk_xml()
/// \throw MachineError if a file cannot be opened or read
FieldMesh read_vtk_xml(const std::filesystem::path& file);

}  // namespace interleaf
