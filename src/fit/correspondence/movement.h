// Moves the mesh of one body over another one in several passes from coarse to fine, and keeps the best.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>

#include "fit/correspondence/moving_mesh.h"
#include "fit/mesh/progress_meter.h"

namespace interleaf {

struct MovementOptions {
    std::size_t vertices = 8000;  ///< of the mesh that passes end with
    int max_passes = 10;          ///< at least 1
    double enough = 1.01;         ///< no further pass once the distortion is below this
    int max_idle_passes = 2;      ///< no further pass after so many that gain less than a hundredth
};

/// Fractions of the meter's work.
struct PartOfWork {
    double begin = 0;
    double end = 1;
};

/// The passes of one moving mesh over one body.
class Movement {
  public:
    /// \param mesh   with all its vertices, which put_at_own_points() has placed
    /// \param meter  must outlive this object
    /// \throw Cancelled
    Movement(MovingMesh mesh, const MovementOptions& options, ProgressMeter& meter);

    /// Makes the first passes. Only the best of them reaches the finest mesh.
    /// \return false if there is no room for the vertices
    /// \throw Cancelled
    bool start(const PartOfWork& part);

    /// Makes the other passes.
    /// \pre start() found room
    /// \throw Cancelled
    void go_on(const PartOfWork& part);

    /// How well the bodies agree so far.
    /// \pre start() found room
    const MatchFigures& figures() const { return best_.figures; }

    /// The mesh with all its vertices in their best places so far; none if there is no room for all.
    /// \pre start() found room
    /// \throw Cancelled
    std::optional<MovingMesh> finished() const;

    int passes() const { return passes_; }

  private:
    struct Best {
        MovingMesh::Places places;
        MatchFigures figures{.energy = std::numeric_limits<double>::infinity()};
    };

    void enter_pass(const PartOfWork& part, int all_passes);
    void coarsen_own(std::uint32_t variation);
    bool has_found() const { return best_.figures.energy < std::numeric_limits<double>::infinity(); }
    void relax_coarse();
    double keep_if_better();

    MovingMesh mesh_;
    MovementOptions options_;
    ProgressMeter& meter_;
    Best best_;
    int passes_ = 0;
};

}  // namespace interleaf
