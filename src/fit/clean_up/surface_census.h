// The figures of a mesh as a file gives it, closed or not, for people who ask what it is.
#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include <glm/vec3.hpp>

#include "fit/mesh/surface_mesh.h"

namespace interleaf {

struct SurfaceCensus {
    std::size_t vertices = 0;   ///< in use, equal ones counted once
    std::size_t triangles = 0;  ///< less degenerate and duplicate ones
    double area = 0;            ///< in squared units of the positions

    /// That the surface encloses; none unless it is closed and two-sided. Parts that look inward, as the
    /// walls of a cavity do, count against it where all triangles of the mesh agree.
    std::optional<double> volume;

    std::size_t parts = 0;               ///< components, where triangles are joined by their edges
    std::size_t openings = 0;            ///< rims of holes
    std::optional<std::size_t> handles;  ///< of all parts; none where one of them is one-sided
    std::size_t crowded_edges = 0;       ///< at which more than two triangles meet
    std::size_t welded_vertices = 0;     ///< of the file, equal to another or nearly so (near_welding.h)
    std::size_t removed_triangles = 0;   ///< degenerate or duplicate
};

/// Of any triangles, after the first steps of clean_up(): equal vertices are welded, double triangles
/// removed, crowded edges parted. \pre positions are finite, vertices exist
SurfaceCensus census_of(SurfaceMesh mesh);

/// The same of a mesh whose vertices are what they are: nothing is welded or removed.
SurfaceCensus census_as_it_is(SurfaceMesh mesh);

}  // namespace interleaf
