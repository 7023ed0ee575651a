// Pairs of meshes of one generated body, whose correspondence is known: the input of the property test of matching.
#pragma once

#include <cstdint>
#include <vector>

#include "fit/mesh/surface_mesh.h"
#include "fit/star_shapes.h"

namespace interleaf::testing {

/// One body with bumps, as two unrelated meshes. The second mesh is scaled, turned by up to 20 degrees and noisy, and
/// has another number of vertices.
struct GeneratedPair {
    MappedMesh first;                ///< its points are the directions from the body's middle
    MappedMesh second;               ///< in the first mesh's directions, too
    std::vector<glm::dvec3> places;  ///< per vertex of the second mesh, where it belongs on the first
};

/// The same seed gives the same bits.
/// \param divisions  of the finer mesh: 20 4^n triangles, before it is made denser on one side
GeneratedPair generated_pair(std::uint64_t seed, unsigned divisions);

/// How well matching finds the correspondence of a pair, without landmarks, from maps that are made and aligned as
/// for a fit.
struct PairFigures {
    double mean_error =
        0;  ///< distance from where a vertex is matched to where it belongs, over the box diagonal
    double unmatched = 0;  ///< the same without matching
    bool is_one_to_one = false;
    bool is_matched = false;
};
PairFigures figures_of(const GeneratedPair& pair);

}  // namespace interleaf::testing
