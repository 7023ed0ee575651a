// One piece of a VTK data set: points, cells and their fields, as a file has them; and the triangles that they
// become.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include <glm/vec3.hpp>

#include "hierarchy/field_mesh.h"
#include "io/vtk/number_array.h"

namespace interleaf {

/// Types of cells (vtkCellType.h) that a reader makes itself.
inline constexpr std::uint8_t vertex_cells = 2;
inline constexpr std::uint8_t line_cells = 4;
inline constexpr std::uint8_t strip_cells = 6;
inline constexpr std::uint8_t polygon_cells = 7;

struct VtkCells {
    std::vector<std::uint8_t> types;  ///< one per cell
    std::vector<Index> ends;          ///< per cell, the number of corners up to its last
    std::vector<Index> corners;       ///< points, cell after cell
};

struct VtkPiece {
    std::vector<glm::dvec3> points;
    VtkCells cells;
    std::vector<bool> is_left_out;  ///< per cell, whether it is a copy or hidden; empty if there are no marks
    std::vector<MeshField> point_fields;
    std::vector<MeshField> cell_fields;
    std::size_t content_size = 0;  ///< bytes that the piece takes in its file, uncompressed
};

/// Whether an array of a data set called \p name is its time: "TimeValue" of ParaView, "TIME" of VisIt.
bool is_time_array(std::string_view name);

/// The time that \p array is; none unless it is one finite number.
std::optional<double> time_in(const NumberArray& array);

/// Appends \p more to \p cells.
/// \throw InputError naming \p file, if they have too many corners together
void append_cells(VtkCells& cells, const VtkCells& more, std::string_view file);

/// The marks `vtkGhostType` (\p are_levels false) or `vtkGhostLevels` (true): whether each cell is left out.
std::vector<bool> left_out_cells(const std::vector<std::uint8_t>& marks, bool are_levels);

/// The triangles of \p piece. Quadrilaterals become two triangles, triangle strips as many as they have.
/// Points, lines and cells that are left out have none.
/// \pre   there are as many types as ends; corners name points; fields have the size of points and cells
/// \throw InputError naming \p file and the cell, if the ends do not fit the corners, or if a cell is neither a
///                   triangle nor a quadrilateral; or if there are more triangles, or values at them, than a file
///                   of this content can have
FieldMesh mesh_of(VtkPiece piece, std::string_view file);

/// Appends the points, triangles and values of \p more to \p mesh. Its cells get the numbers behind the cells of
/// \p mesh. The time stays, unless \p mesh is empty: then \p more replaces it.
/// \throw InputError naming \p file, unless both have the same fields at points, and, if both have triangles, at these
void append(FieldMesh& mesh, FieldMesh more, std::string_view file);

}  // namespace interleaf
