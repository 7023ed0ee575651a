#include "fit/correspondence/movement.h"

#include <array>
#include <cstdint>
#include <limits>

namespace interleaf {
namespace {

/// The meshes from which the first passes start, in vertices. Which one gives the best match differs.
constexpr std::array<std::size_t, 3> start_sizes = {100, 400, 200};

/// To these numbers of vertices, the best match so far is coarsened in the passes after the first ones.
constexpr std::array<std::size_t, 5> pass_sizes = {500, 300, 1000, 700, 400};

/// Maximum number of sweeps whenever the moving mesh has grown by a quarter: up to the even mesh, and beyond it.
constexpr int sweeps_per_growth = 60;
constexpr int sweeps_beyond_even = 20;

struct Movement {
    MovementResult result;
    MovingMesh::Places places;
    MatchFigures figures;
};

/// Makes the passes, up to the base of \p mesh.
Movement best_movement(MovingMesh& mesh, const MovementOptions& options, ProgressMeter& meter) {
    constexpr int sweeps_of_coarse = 300;
    constexpr double stiffer = 3;
    constexpr double idle_part = 0.99;
    const std::size_t all = mesh.count();
    const double part_of_pass = (options.part_ends - options.part_begins) / (options.max_passes + 1);
    Movement best;
    best.figures.energy = std::numeric_limits<double>::infinity();
    bool is_found = false;
    int& passes = best.result.passes;
    int idle_passes = 0;
    for (int pass = 0; pass < options.max_passes && idle_passes < options.max_idle_passes; ++pass) {
        meter.enter("matching", options.part_begins + part_of_pass * pass);
        const auto number = static_cast<std::size_t>(pass);
        if (number == start_sizes.size() && is_found && best.figures.distortion > options.max_distortion) {
            best.result.outcome = MovementOutcome::too_unlike;
            return best;
        }
        if (number < start_sizes.size() || !is_found) {
            mesh.put_at_own_points();
            mesh.coarsen_to(start_sizes[number % start_sizes.size()],
                            number < start_sizes.size() ? 0 : static_cast<std::uint32_t>(pass), false);
        } else {
            mesh.set_places(best.places);
            mesh.coarsen_to(pass_sizes[number % pass_sizes.size()], static_cast<std::uint32_t>(pass), true);
        }
        mesh.set_weights(weights_at(double(mesh.count())));
        mesh.relax(sweeps_of_coarse);
        if (!mesh.refine(sweeps_per_growth)) continue;
        const MatchFigures figures = mesh.figures();
        passes = pass + 1;
        const bool is_idle = number >= start_sizes.size() && figures.energy > idle_part * best.figures.energy;
        idle_passes = is_idle ? idle_passes + 1 : 0;
        if (!(figures.energy < best.figures.energy)) continue;
        is_found = true;
        best.places = mesh.places();
        best.figures = figures;
        if (figures.distortion < options.enough) break;
    }
    if (!is_found) return best;
    best.result.outcome = MovementOutcome::moved;
    meter.enter("matching", options.part_begins + part_of_pass * options.max_passes);
    mesh.set_places(best.places);
    mesh.set_weights(weights_at(double(all)));
    mesh.relax_stiffly(stiffer);
    best.places = mesh.places();
    best.figures = mesh.figures();
    return best;
}

}  // namespace

MovementResult move_to_best(MovingMesh& mesh, const MovementOptions& options, ProgressMeter& meter) {
    meter.enter("matching", options.part_begins);
    mesh.make_base(options.vertices);
    Movement best = best_movement(mesh, options, meter);
    mesh.leave_base();
    if (best.result.outcome != MovementOutcome::moved) {
        mesh.restore_all();
        return best.result;
    }
    mesh.set_places(best.places);
    if (!mesh.refine(sweeps_beyond_even)) best.result.outcome = MovementOutcome::no_room;
    return best.result;
}

}  // namespace interleaf
