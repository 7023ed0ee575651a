// The files of a series: meshes at different times, each of which is a step.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "hierarchy/field_mesh.h"
#include "io/mesh/surface_file.h"

namespace interleaf {

struct SeriesFiles {
    std::vector<std::filesystem::path> files;  ///< the first file of each step, in the order of time
    std::vector<double> times;                 ///< one per step, strictly increasing
    std::vector<std::vector<std::filesystem::path>> further_parts;  ///< per step, its other files; often none
    bool are_steps = false;  ///< the times are numbers of files, not those of a list
};

/// The files of a series that \p paths name: one list of ParaView, a collection (.pvd) or a file series in JSON
/// (.vtu.series, .vtk.series, ...); or the files of meshes, of which each path may be a pattern (file/file_pattern.h).
///
/// The times of a list are in it, and its files are relative to its folder. Files of a collection at one time with
/// different numbers (attribute part) are parts of one step. A file of a collection without a time belongs to the step
/// of the file before it if its part is not 0; else its time is the number of steps before it. The times of files are
/// the numbers in their names, if the names differ in one number alone; otherwise they are 0, 1, 2, ...
/// \throw InputError   naming the file and the place, if a list is damaged, names a file that is not there, or has
///                     two files at one time that are no different parts of a step; or if no file matches a pattern
/// \throw MachineError if a file or folder cannot be read
SeriesFiles series_files(std::span<const std::filesystem::path> paths);

/// The name of the family of a series whose first path is \p path: "run" for run.pvd, run.vtu.series and run.vtu.
std::string series_name(const std::filesystem::path& path);

/// Reads one step of a series, of any format with triangles: .vtu, .pvtu, .vtp, .pvtp, .vtk, and the formats of
/// meshes. Colors become the point field "color".
/// \throw InputError   naming the file, the place and what was expected; also if there is no triangle
/// \throw MachineError if a file cannot be opened or read
FieldMesh read_field_mesh(const std::filesystem::path& file);

/// Reads one step of \p series. Its parts become one mesh, as the pieces of a .pvtu file do.
/// \throw InputError, MachineError as read_field_mesh(); InputError also if the parts have different fields
FieldMesh read_step_mesh(const SeriesFiles& series, std::size_t step);

/// Reads a mesh to fit a key to: a file of a format of meshes, or a step of a series, whose point fields become
/// scalars.
/// \throw InputError, MachineError as read_surface() (read_files.h) or read_field_mesh()
SurfaceFile read_mesh_to_fit(const std::filesystem::path& file);

}  // namespace interleaf
