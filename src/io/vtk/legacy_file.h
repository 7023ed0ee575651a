// Reads the legacy format of VTK (.vtk), as words or binary: unstructured grids and polygons, from version 1.0 to
// version 5.1. Quadratic cells and volumes are refused by name.
#pragma once

#include <string>
#include <string_view>

#include "hierarchy/field_mesh.h"

namespace interleaf {

/// Reads the content \p bytes of a .vtk file. Messages call the file \p name. Cells and arrays are left out as by
/// parse_vtk_xml().
/// \throw InputError naming the file, the place and what was expected
FieldMesh parse_legacy_vtk(std::string_view bytes, const std::string& name);

}  // namespace interleaf
