// Moves the mesh of one body over another one in several passes from coarse to fine, and keeps the best.
#pragma once

#include <cstddef>
#include <limits>

#include "fit/correspondence/moving_mesh.h"
#include "fit/mesh/progress_meter.h"

namespace interleaf {

struct MovementOptions {
    std::size_t vertices = 8000;  ///< of the mesh that passes end with
    int max_passes = 10;          ///< at least 1
    double enough = 1.01;         ///< no further pass once the distortion is below this
    int max_idle_passes = 2;      ///< no further pass after so many that gain less than a hundredth
    /// Bodies are too unlike if the distortion is above this after the first three passes. Then the passes end.
    double max_distortion = std::numeric_limits<double>::infinity();
    double part_begins = 0;  ///< fractions of the meter's work
    double part_ends = 1;
};

enum class MovementOutcome {
    moved,
    no_room,  ///< for all vertices
    too_unlike
};

struct MovementResult {
    MovementOutcome outcome = MovementOutcome::no_room;
    int passes = 0;
};

/// Leaves the vertices of \p mesh in their best places; in no useful places unless the outcome is `moved`.
/// \param mesh  with all its vertices, which put_at_own_points() has placed
/// \throw Cancelled
MovementResult move_to_best(MovingMesh& mesh, const MovementOptions& options, ProgressMeter& meter);

}  // namespace interleaf
