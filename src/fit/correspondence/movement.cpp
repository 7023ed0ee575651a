#include "fit/correspondence/movement.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

namespace interleaf {
namespace {

/// The meshes from which the first passes start, in vertices. Which one gives the best match differs.
constexpr std::array<std::size_t, 3> start_sizes = {100, 400, 200};

/// To these numbers of vertices, the best match so far is coarsened in the passes after the first ones.
constexpr std::array<std::size_t, 5> pass_sizes = {500, 300, 1000, 700, 400};

/// Maximum number of sweeps whenever the moving mesh has grown by a quarter: up to the even mesh, and beyond it.
constexpr int sweeps_per_growth = 60;
constexpr int sweeps_beyond_even = 20;

/// A first pass goes on beyond this number of vertices only if it has the least energy of the first passes there. The
/// order of their energies hardly changes any more.
constexpr std::size_t compared_vertices = 1400;

}  // namespace

Movement::Movement(MovingMesh mesh, const MovementOptions& options, ProgressMeter& meter)
    : mesh_(std::move(mesh)), options_(options), meter_(meter) {
    mesh_.make_base(options_.vertices);
}

void Movement::enter_pass(const PartOfWork& part, int all_passes) {
    meter_.enter("matching", part.begin + (part.end - part.begin) * passes_ / all_passes);
}

/// Coarsens the mesh where the given map puts it.
void Movement::coarsen_own(std::uint32_t variation) {
    mesh_.put_at_own_points();
    mesh_.coarsen_to(start_sizes[static_cast<std::size_t>(passes_) % start_sizes.size()], variation, false);
}

void Movement::relax_coarse() {
    constexpr int sweeps_of_coarse = 300;
    mesh_.set_weights(weights_at(double(mesh_.count())));
    mesh_.relax(sweeps_of_coarse);
}

/// \return the energy
double Movement::keep_if_better() {
    const MatchFigures figures = mesh_.figures();
    if (figures.energy < best_.figures.energy) best_ = {mesh_.places(), figures};
    return figures.energy;
}

bool Movement::start(const PartOfWork& part) {
    const int first_passes = std::min(options_.max_passes, int(start_sizes.size()));
    std::vector<std::pair<double, std::unique_ptr<MovingMesh>>> starts;
    for (bool is_enough = false; passes_ < first_passes && !is_enough; ++passes_) {
        enter_pass(part, first_passes);
        coarsen_own(0);
        relax_coarse();
        if (!mesh_.refine(sweeps_per_growth, compared_vertices)) continue;
        auto start = std::make_unique<MovingMesh>(mesh_);
        const MatchFigures figures = mesh_.figures();
        starts.emplace_back(figures.energy, std::move(start));
        is_enough = figures.distortion < options_.enough;
        mesh_.restore_all();
    }
    std::ranges::sort(starts, {}, [](const auto& start) { return start.first; });
    for (const auto& [energy, mesh] : starts) {
        if (!mesh->refine(sweeps_per_growth)) continue;
        mesh_.set_places(mesh->places());
        mesh_.set_weights(weights_at(double(mesh_.count())));
        keep_if_better();
        return true;
    }
    for (; passes_ < options_.max_passes && !has_found(); ++passes_) {
        meter_.enter("matching", part.end);
        coarsen_own(static_cast<std::uint32_t>(passes_));
        relax_coarse();
        if (mesh_.refine(sweeps_per_growth)) keep_if_better();
    }
    return has_found();
}

void Movement::go_on(const PartOfWork& part) {
    constexpr double idle_part = 0.99;
    for (int idle_passes = 0; passes_ < options_.max_passes && idle_passes < options_.max_idle_passes &&
                              !(best_.figures.distortion < options_.enough);
         ++passes_) {
        enter_pass(part, options_.max_passes);
        mesh_.set_places(best_.places);
        mesh_.coarsen_to(pass_sizes[static_cast<std::size_t>(passes_) % pass_sizes.size()],
                         static_cast<std::uint32_t>(passes_), true);
        relax_coarse();
        const double before = best_.figures.energy;
        if (!mesh_.refine(sweeps_per_growth)) continue;
        idle_passes = keep_if_better() > idle_part * before ? idle_passes + 1 : 0;
    }
}

std::optional<MovingMesh> Movement::finished() const {
    constexpr double stiffer = 3;
    std::optional<MovingMesh> mesh = mesh_;
    mesh->set_places(best_.places);
    mesh->set_weights(weights_at(double(mesh->count())));
    mesh->relax_stiffly(stiffer);
    mesh->leave_base();
    if (!mesh->refine(sweeps_beyond_even)) mesh.reset();
    return mesh;
}

}  // namespace interleaf
