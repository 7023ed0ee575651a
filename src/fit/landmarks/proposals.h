// Proposes landmarks: the extremities of a body, such as nose, feet and tips of ears. They are the local maxima
// of the mean distance, along the surface, from all other points (Hilaga et al. 2001), as far as they stand out
// (persistence: Edelsbrunner, Letscher and Zomorodian 2002).
#pragma once

#include <cstddef>
#include <vector>

#include "fit/mesh/surface_mesh.h"
#include "hierarchy/progress.h"

namespace interleaf {

struct Extremity {
    Index vertex = no_index;
    /// How far the mean distance falls on the way to a higher maximum, as a fraction of its range; 1 for the
    /// highest maximum.
    double persistence = 0;
};

struct ProposalOptions {
    std::size_t max_count = 16;
    double persistence = 0.03;  ///< at least
};

/// The most persistent extremities, in falling order.
/// \param mesh  clean (clean_up.h)
/// \throw Cancelled when \p progress says so
std::vector<Extremity> find_extremities(const SurfaceMesh& mesh, const ProposalOptions& options,
                                        const Progress& progress);

}  // namespace interleaf
