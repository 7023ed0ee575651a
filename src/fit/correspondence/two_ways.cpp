#include "fit/correspondence/two_ways.h"

#include <algorithm>
#include <array>
#include <utility>

#include <glm/geometric.hpp>

#include "fit/correspondence/finished_map.h"
#include "fit/correspondence/pull_back.h"
#include "fit/mesh/parallel_work.h"
#include "fit/sampling/sphere_location.h"
#include "fit/sphere_map/spherical_map.h"

namespace interleaf {
namespace {

/// The fractions of the whole work at which the parts of both ways begin.
constexpr double model_moves_from = 0.2;
constexpr double going_on_begins = 0.3;
constexpr double model_goes_on_from = 0.45;

/// The model's mesh also moves over the body, unless the distortion is below this without that.
constexpr double good_distortion = 1.15;

/// Bodies whose distortion stays above this have no parts that correspond, and no good key of a match. With landmarks,
/// a person knows better.
constexpr double hopeless_distortion = 3.5;

/// The body's mesh waits if its energy after the first passes is over this multiple of that of the model's mesh.
constexpr double clearly_worse = 1.1;

/// Where the whole body cannot be pulled back, it is on so many of its vertices.
constexpr std::array<std::size_t, 3> pulled_back_vertices = {8000, 4000, 1000};

/// Whether \p points are a map of \p mesh that is one to one.
bool covers_once(const SphereMesh& mesh, std::span<const glm::dvec3> points) {
    return fault_of_map({.positions = mesh.positions, .triangles = mesh.triangles, .colors = {}}, points)
        .empty();
}

/// Where a map of \p body puts the vertices of the model on \p moved.
/// \param points  the map, one per vertex of \p body
MovingMesh::Places places_by_map(const SphereMesh& body, std::span<const glm::dvec3> points,
                                 const MatchedBody& model, const MatchedBody& moved) {
    const SphereLocation in_map(body.triangles, points);
    MovingMesh::Places places;
    Index guess = no_index;
    Index guess_on_body = no_index;
    for (const glm::dvec3& point : model.points()) {
        const MeshPoint on_body = in_map.locate(point, guess);
        guess = on_body.triangle;
        const glm::dvec3 direction =
            glm::normalize(on_body.of(std::span(body.triangles), std::span(body.points)));
        const MeshPoint place = moved.locate(direction, guess_on_body);
        guess_on_body = place.triangle;
        places.on_mesh.push_back(place);
        places.in_space.push_back(moved.position(place));
        places.on_sphere.push_back(direction);
    }
    return places;
}

MatchFigures mean_of(const MatchFigures& a, const MatchFigures& b) {
    return {.energy = (a.energy + b.energy) / 2,
            .distortion = (a.distortion + b.distortion) / 2,
            .mean_cosine = (a.mean_cosine + b.mean_cosine) / 2,
            .stretched = (a.stretched + b.stretched) / 2};
}

}  // namespace

TwoWays::TwoWays(const MatchedBody& model, const SphereMesh& body, CoarsenedMesh compared,
                 std::size_t models_vertices, const MovementOptions& movement, const Progress& progress)
    : model_(model),
      body_(body),
      compared_(std::move(compared)),
      moved_(compared_.mesh, part_of(progress, moving_begins * measuring_begins, moving_begins)),
      models_vertices_(models_vertices),
      movement_(movement),
      progress_(progress),
      meter_(progress),
      own_mesh_(moved_, model, meter_),
      models_mesh_(model, moved_, meter_),
      own_weights_(weights_at(double(own_mesh_.count()))),
      models_weights_(weights_at(double(models_mesh_.count()))) {}

MatchFigures TwoWays::figures_of(std::span<const glm::dvec3> points) {
    std::vector<glm::dvec3> compared_points;
    compared_points.reserve(compared_.vertices.size());
    for (const Index vertex : compared_.vertices) compared_points.push_back(points[vertex]);
    own_mesh_.put_at(compared_points);
    own_mesh_.set_weights(own_weights_);
    models_mesh_.set_places(places_by_map(body_, points, model_, moved_));
    models_mesh_.set_weights(models_weights_);
    return mean_of(own_mesh_.figures(), models_mesh_.figures());
}

std::vector<Candidate> TwoWays::candidates() {
    start_own();
    if (are_too_unlike_) return {};
    std::vector<Candidate> found;
    if (own_.figures && own_.figures->distortion <= good_distortion) {
        go_on_with_own({model_moves_from, model_moves_from}, found);
        if (!found.empty()) return found;
    }
    start_models();
    ParallelWork<std::optional<Candidate>> models(
        [&](const Progress& progress) { return go_on_with_models(progress); });
    if (!own_.has_gone_on && !is_own_clearly_worse())
        go_on_with_own({going_on_begins, model_goes_on_from}, found);
    if (auto candidate = models.wait("matching", part_of(progress_, model_goes_on_from, finishing_begins)))
        found.push_back(measured(*std::move(candidate)));
    models_progress_ = {};
    const bool has_waited_in_vain = !own_.has_gone_on && own_.figures && !found.empty() &&
                                    own_.figures->energy < found.front().figures.energy;
    if (has_waited_in_vain) go_on_with_own({finishing_begins, finishing_begins}, found);
    std::ranges::sort(found, {}, [](const Candidate& candidate) { return candidate.figures.energy; });
    return found;
}

std::vector<Candidate> TwoWays::waiting_candidates(double part) {
    std::vector<Candidate> found;
    if (!own_.has_gone_on) go_on_with_own({part, part}, found);
    return found;
}

bool TwoWays::restore(double worst, int sweeps, Candidate& candidate) {
    if (!restore_shapes(body_, worst, sweeps, candidate.points, meter_)) return false;
    if (is_one_to_one(candidate)) candidate.figures = figures_of(candidate.points);
    return true;
}

bool TwoWays::is_one_to_one(const Candidate& candidate) const {
    return covers_once(body_, candidate.points);
}

bool TwoWays::is_own_clearly_worse() const {
    if (!own_.figures || !models_.movement) return false;
    if (models_.figures && own_.figures->energy > clearly_worse * models_.figures->energy) return true;
    return body_.landmarks.empty() && own_.figures->distortion > hopeless_distortion;
}

void TwoWays::start_own() {
    begin_part(moving_begins);
    own_mesh_.put_at_own_points();
    own_mesh_.set_weights(own_weights_);
    MovingMesh moving = own_mesh_;
    moving.avoid_needles();
    own_.movement.emplace(std::move(moving), movement_, meter_);
    if (!own_.movement->start({moving_begins, model_moves_from})) return own_.movement.reset();
    are_too_unlike_ = body_.landmarks.empty() && own_.movement->figures().distortion > hopeless_distortion;
    if (are_too_unlike_) return;
    if (const auto candidate = own_candidate()) own_.figures = candidate->figures;
}

void TwoWays::go_on_with_own(const PartOfWork& part, std::vector<Candidate>& found) {
    own_.has_gone_on = true;
    if (!own_.movement) return;
    own_.movement->go_on(part);
    if (auto candidate = own_candidate()) found.push_back(*std::move(candidate));
}

/// The result never turns over.
std::optional<Candidate> TwoWays::own_candidate() {
    const std::optional<MovingMesh> moved = own_.movement->finished();
    if (!moved) return std::nullopt;
    CoarsenedMesh compared = compared_;
    Candidate candidate;
    candidate.points = finished_map(body_, compared, moved->places().on_sphere, meter_);
    candidate.passes = own_.movement->passes();
    std::optional<Candidate> found = restored(std::move(candidate), meter_);
    if (found) found = measured(*std::move(found));
    return found;
}

void TwoWays::start_models() {
    const Progress still = part_of(progress_, model_moves_from, model_moves_from);
    even_model_.emplace(coarsened(model_.mesh(), models_vertices_, still).mesh, still);
    even_body_.emplace(coarsened(body_, movement_.vertices, still).mesh, still);
    models_progress_ = progress_;
    models_meter_.enter("matching", model_moves_from);
    MovementOptions options = movement_;
    options.vertices = even_model_->points().size();
    if (!body_.landmarks.empty()) options.max_idle_passes = options.max_passes;
    models_.movement.emplace(MovingMesh(*even_model_, *even_body_, models_meter_), options, models_meter_);
    if (!models_.movement->start({model_moves_from, going_on_begins})) return models_.movement.reset();
    if (auto candidate = models_candidate(false)) models_.figures = figures_of(candidate->points);
}

/// \return without figures
std::optional<Candidate> TwoWays::go_on_with_models(const Progress& progress) {
    if (!models_.movement) return std::nullopt;
    models_progress_ = progress;
    models_.movement->go_on({0, 1});
    return models_candidate(true);
}

/// Inverts the movement of the model's mesh.
/// \return without figures
std::optional<Candidate> TwoWays::models_candidate(bool also_coarsely) {
    const std::optional<MovingMesh> moved = models_.movement->finished();
    if (!moved) return std::nullopt;
    const std::span<const glm::dvec3> on_sphere = moved->places().on_sphere;
    Candidate candidate;
    candidate.passes = models_.movement->passes();
    candidate.points = pull_back(body_, even_model_->mesh(), on_sphere, models_meter_);
    // Small triangles turn over where the inverse is not smooth. On a coarse mesh, there are none.
    const Progress pulling_back = [&](std::string_view, double) {
        models_meter_.step();
        return true;
    };
    for (const std::size_t vertices : pulled_back_vertices) {
        if (!also_coarsely || is_one_to_one(candidate)) break;
        CoarsenedMesh coarse = coarsened(body_, vertices, pulling_back);
        const std::vector<glm::dvec3> points =
            pull_back(coarse.mesh, even_model_->mesh(), on_sphere, models_meter_);
        if (!covers_once(coarse.mesh, points)) continue;
        std::vector<glm::dvec3> finished = finished_map(body_, coarse, points, models_meter_);
        if (!finished.empty()) candidate.points = std::move(finished);
    }
    return restored(std::move(candidate), models_meter_);
}

/// \return the candidate with its worst shapes restored, without figures; none if it is not one to one
std::optional<Candidate> TwoWays::restored(Candidate candidate, ProgressMeter& meter) const {
    if (candidate.points.empty() || !is_one_to_one(candidate)) return std::nullopt;
    restore_shapes(body_, worst_kept_shape, usual_sweeps, candidate.points, meter);
    if (!is_one_to_one(candidate)) return std::nullopt;
    return candidate;
}

Candidate TwoWays::measured(Candidate candidate) {
    candidate.figures = figures_of(candidate.points);
    return candidate;
}

}  // namespace interleaf
