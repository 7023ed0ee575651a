// The figures that describe a mesh as it is in the file, closed or not.
#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include <glm/vec3.hpp>

#include "fit/mesh/surface_mesh.h"

namespace interleaf {

struct SurfaceCensus {
    std::size_t vertices = 0;   ///< used vertices; equal ones count once
    std::size_t triangles = 0;  ///< without degenerate and duplicate ones
    double area = 0;            ///< in squared units of the positions

    /// The enclosed volume; none unless the surface is closed and two-sided. Where all triangles of the mesh
    /// agree, parts that look inward, such as the walls of a cavity, are subtracted.
    std::optional<double> volume;

    std::size_t parts = 0;               ///< components, where triangles are joined by their edges
    std::size_t openings = 0;            ///< number of rims of holes
    std::optional<std::size_t> handles;  ///< of all parts; none if a part is one-sided
    std::size_t crowded_edges = 0;       ///< edges at which more than two triangles meet
    std::size_t welded_vertices = 0;     ///< equal or nearly equal to another one (near_welding.h)
    std::size_t removed_triangles = 0;   ///< degenerate or duplicate
};

/// The figures of any triangles, after the first steps of clean_up(): equal vertices are welded, duplicate
/// triangles removed, and crowded edges separated.
/// \pre positions are finite, and there is at least one vertex
SurfaceCensus census_of(SurfaceMesh mesh);

/// The same figures of the mesh as it is: nothing is welded or removed.
SurfaceCensus census_as_it_is(SurfaceMesh mesh);

}  // namespace interleaf
