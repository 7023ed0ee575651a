#include "fit/correspondence/match.h"

#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <utility>

#include <glm/geometric.hpp>

#include "fit/correspondence/direction_insertion.h"
#include "fit/correspondence/even_mesh.h"
#include "fit/correspondence/finished_map.h"
#include "fit/correspondence/movement.h"
#include "fit/correspondence/pull_back.h"
#include "fit/correspondence/sphere_mesh.h"
#include "fit/landmarks/similarity.h"
#include "fit/sphere_map/spherical_map.h"
#include "hierarchy/error.h"

namespace interleaf {
namespace {

/// The fractions of the whole work at which its parts begin.
constexpr double moving_begins = 0.1;
constexpr double model_moves_from = 0.2;
constexpr double going_on_begins = 0.3;
constexpr double model_goes_on_from = 0.45;
constexpr double finishing_begins = 0.6;

/// The same of the comparison of one body.
constexpr double measuring_begins = 0.3;

/// Bodies with more vertices than this multiple of the even mesh's are compared on a coarser mesh.
constexpr std::size_t finest_part = 3;

/// The model's mesh also moves over the body, unless the distortion is below this without that.
constexpr double good_distortion = 1.15;

/// Maps of a small distortion agree already if the rest of the energy, differences of places and normals, is below
/// this.
constexpr double max_disagreement = 0.01;

/// Bodies whose distortion stays above this have no parts that correspond, and no good key of a match. With landmarks,
/// a person knows better.
constexpr double hopeless_distortion = 3.5;

/// The body's mesh waits if its energy after the first passes is over this multiple of that of the model's mesh.
constexpr double clearly_worse = 1.1;

/// At the end, shapes on the sphere are restored where their distortion is larger than this.
constexpr double worst_shape = 4;

/// Where that gives no good key, more shapes are restored: in one large step, which keeps more area between bone and
/// sphere of the five keys, then from the first map again in small ones, which more often give a good key.
struct Restoring {
    double worst_shape;
    bool begins_anew = false;
};
constexpr std::array<Restoring, 5> restorings = {{{worst_shape}, {1.3}, {2, true}, {1.3}, {1}}};
constexpr std::array<Restoring, 4> restorings_with_landmarks = {{{worst_shape}, {2}, {1.3}, {1}}};

/// Vertices of the even mesh of a body with \p count vertices. Over twice as many would only cost time.
std::size_t even_vertices(const MatchOptions& options, std::size_t count) {
    constexpr std::size_t least = 1500;
    return std::min(options.vertices, std::max(least, 2 * count));
}

std::vector<std::array<Index, 2>> split(SphereMesh& body, std::size_t vertices, const Progress& progress) {
    ProgressMeter meter(progress);
    meter.enter("making an even mesh", 0);
    return split_long_edges(body, vertices, meter);
}

/// \p body on at most \p vertices vertices.
CoarsenedMesh compared_part(const SphereMesh& body, std::size_t vertices, const Progress& progress) {
    ProgressMeter meter(progress);
    meter.enter("making an even mesh", 0);
    return coarsened(body, vertices, meter);
}

/// Turns \p body so that its landmarks come nearest to those of \p model, if they determine a rotation.
void turn_to_landmarks(SphereMesh& body, const MatchedBody& model) {
    constexpr std::size_t fewest = 3;
    std::vector<glm::dvec3> from;
    std::vector<glm::dvec3> to;
    for (const SphereLandmark& own : body.landmarks) {
        const auto there = std::ranges::find(model.landmarks(), own.direction, &SphereLandmark::direction);
        if (there == model.landmarks().end()) continue;
        from.push_back(body.positions[own.vertex]);
        to.push_back(model.positions()[there->vertex]);
    }
    if (from.size() < fewest) return;
    try {
        const glm::dmat3 rotation = fit_similarity(from, to, false).rotation;
        for (glm::dvec3& position : body.positions) position = rotation * position;
    } catch (const InputError&) {
        return;  // they lie on one line
    }
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

/// A map of the whole body, and how well it agrees with the model's.
struct Candidate {
    std::vector<glm::dvec3> points;
    MatchFigures figures;
    int passes = 0;
};

/// The two bodies of one match.
class Match {
  public:
    Match(const MatchedBody& model, const SphereMesh& body, CoarsenedMesh compared, std::size_t vertices,
          const MatchOptions& options, const Progress& progress)
        : model_(model),
          body_(body),
          compared_(std::move(compared)),
          moved_(compared_.mesh, part_of(progress, moving_begins * measuring_begins, moving_begins)),
          models_vertices_(options.vertices),
          movement_{.vertices = vertices, .max_passes = options.max_passes, .enough = options.enough},
          progress_(progress),
          meter_(progress),
          own_mesh_(moved_, model, meter_),
          models_mesh_(model, moved_, meter_),
          own_weights_(weights_at(double(own_mesh_.count()))),
          models_weights_(weights_at(double(models_mesh_.count()))) {}
    Match(const Match&) = delete;
    Match& operator=(const Match&) = delete;

    /// How well a map agrees with the model's: the mean over the body's mesh on the model and the model's mesh on the
    /// body. Either alone steps over what the other body has between two of its vertices.
    MatchFigures figures_of(std::span<const glm::dvec3> points) {
        std::vector<glm::dvec3> compared_points;
        compared_points.reserve(compared_.vertices.size());
        for (const Index vertex : compared_.vertices) compared_points.push_back(points[vertex]);
        own_mesh_.put_at(compared_points);
        own_mesh_.set_weights(own_weights_);
        models_mesh_.set_places(places_by_map(body_, points, model_, moved_));
        models_mesh_.set_weights(models_weights_);
        return mean_of(own_mesh_.figures(), models_mesh_.figures());
    }

    /// Moves the body's mesh over the model and, unless that is good, the model's mesh over the body, which heeds
    /// details that only the model has. If the first way starts clearly worse, it waits for waiting_candidates(). The
    /// second way never waits, since its later passes gain more.
    /// \param tries_hard  where triangles stay turned over, tries again with more weight on shapes
    /// \return the best first; none if are_too_unlike()
    std::vector<Candidate> candidates(bool tries_hard) {
        start_own();
        if (are_too_unlike_) return {};
        std::vector<Candidate> found;
        if (own_.figures && own_.figures->distortion <= good_distortion) {
            go_on_with_own({model_moves_from, model_moves_from}, found);
            if (!found.empty()) return found;
        }
        start_models();
        if (!own_.has_gone_on && !is_own_clearly_worse())
            go_on_with_own({going_on_begins, model_goes_on_from}, found);
        if (models_.movement) {
            models_.movement->go_on({model_goes_on_from, finishing_begins});
            if (auto candidate = models_candidate(tries_hard)) found.push_back(std::move(*candidate));
        }
        std::ranges::sort(found, {}, [](const Candidate& candidate) { return candidate.figures.energy; });
        return found;
    }

    /// The candidate of the way that candidates() left waiting, if there is one.
    /// \param part  of the whole work that is done
    std::vector<Candidate> waiting_candidates(double part) {
        std::vector<Candidate> found;
        if (!own_.has_gone_on) go_on_with_own({part, part}, found);
        return found;
    }

    /// Whether candidates() found no parts that correspond.
    bool are_too_unlike() const { return are_too_unlike_; }

    /// \return false if there is nothing to restore
    bool restore(double worst, Candidate& candidate) {
        if (!restore_shapes(body_, worst, candidate.points, meter_)) return false;
        if (is_one_to_one(candidate)) candidate.figures = figures_of(candidate.points);
        return true;
    }

    void begin_part(double part) { meter_.enter("matching", part); }

    bool is_one_to_one(const Candidate& candidate) const {
        return fault_of_map({.positions = body_.positions, .triangles = body_.triangles, .colors = {}},
                            candidate.points)
            .empty();
    }

  private:
    /// One mesh that moves over the other body.
    struct Way {
        std::optional<Movement> movement;  ///< none if there is no room
        std::optional<MatchFigures>
            figures;  ///< of the candidate after the first passes, if that is one to one
        bool has_gone_on = false;
    };

    bool is_own_clearly_worse() const {
        if (!own_.figures || !models_.movement) return false;
        if (models_.figures && own_.figures->energy > clearly_worse * models_.figures->energy) return true;
        return body_.landmarks.empty() && own_.figures->distortion > hopeless_distortion;
    }

    void start_own() {
        begin_part(moving_begins);
        own_mesh_.put_at_own_points();
        own_mesh_.set_weights(own_weights_);
        MovingMesh moving = own_mesh_;
        moving.avoid_needles();
        own_.movement.emplace(std::move(moving), movement_, meter_);
        if (!own_.movement->start({moving_begins, model_moves_from})) return own_.movement.reset();
        are_too_unlike_ =
            body_.landmarks.empty() && own_.movement->figures().distortion > hopeless_distortion;
        if (are_too_unlike_) return;
        if (const auto candidate = own_candidate()) own_.figures = candidate->figures;
    }

    void go_on_with_own(const PartOfWork& part, std::vector<Candidate>& found) {
        own_.has_gone_on = true;
        if (!own_.movement) return;
        own_.movement->go_on(part);
        if (auto candidate = own_candidate()) found.push_back(std::move(*candidate));
    }

    /// The result never turns over.
    std::optional<Candidate> own_candidate() {
        const std::optional<MovingMesh> moved = own_.movement->finished();
        if (!moved) return std::nullopt;
        CoarsenedMesh compared = compared_;
        Candidate candidate;
        candidate.points = finished_map(body_, compared, moved->places().on_sphere, meter_);
        candidate.passes = own_.movement->passes();
        return finished(std::move(candidate));
    }

    void start_models() {
        const Progress still = part_of(progress_, model_moves_from, model_moves_from);
        even_model_.emplace(compared_part(model_.mesh(), models_vertices_, still).mesh, still);
        even_body_.emplace(compared_part(body_, movement_.vertices, still).mesh, still);
        begin_part(model_moves_from);
        MovementOptions options = movement_;
        options.vertices = even_model_->points().size();
        if (!body_.landmarks.empty()) options.max_idle_passes = options.max_passes;
        models_.movement.emplace(MovingMesh(*even_model_, *even_body_, meter_), options, meter_);
        if (!models_.movement->start({model_moves_from, going_on_begins})) return models_.movement.reset();
        if (const auto candidate = models_candidate(false)) models_.figures = candidate->figures;
    }

    /// Inverts the movement of the model's mesh.
    std::optional<Candidate> models_candidate(bool tries_hard) {
        std::optional<MovingMesh> moved = models_.movement->finished();
        if (!moved) return std::nullopt;
        Candidate candidate;
        candidate.passes = models_.movement->passes();
        for (const double stiffness : {1.0, 10.0, 40.0}) {
            // Less strained places are pulled back with fewer triangles turned over.
            if (stiffness > 1) moved->relax_stiffly(stiffness);
            candidate.points = pull_back(body_, even_model_->mesh(), moved->places().on_sphere, meter_);
            if (!tries_hard || is_one_to_one(candidate)) break;
        }
        return finished(std::move(candidate));
    }

    std::optional<Candidate> finished(Candidate candidate) {
        if (candidate.points.empty() || !is_one_to_one(candidate)) return std::nullopt;
        restore_shapes(body_, worst_shape, candidate.points, meter_);
        if (!is_one_to_one(candidate)) return std::nullopt;
        candidate.figures = figures_of(candidate.points);
        return candidate;
    }

    const MatchedBody& model_;
    const SphereMesh& body_;
    CoarsenedMesh compared_;
    MatchedBody moved_;
    std::size_t models_vertices_;
    MovementOptions movement_;
    const Progress& progress_;
    ProgressMeter meter_;
    MovingMesh own_mesh_;  ///< with all its vertices, to measure
    MovingMesh models_mesh_;
    MatchWeights own_weights_;
    MatchWeights models_weights_;
    Way own_;
    std::optional<MatchedBody> even_model_;
    std::optional<MatchedBody> even_body_;
    Way models_;
    bool are_too_unlike_ = false;
};

MatchedMap unmatched(MatchReport report, std::string fault) {
    report.after = report.before;
    report.fault = std::move(fault);
    return {{}, {}, std::move(report)};
}

}  // namespace

std::unique_ptr<const MatchedBody> model_of(const SurfaceMesh& mesh, std::span<const glm::dvec3> points,
                                            const glm::dmat3& turn, std::span<const glm::dvec3> landmarks,
                                            const MatchOptions& options, const Progress& progress) {
    SphereMesh body = normalized(mesh, points, turn);
    insert_directions(body, landmarks);
    const std::size_t vertices = even_vertices(options, points.size());
    split(body, vertices, progress);
    return std::make_unique<const MatchedBody>(
        compared_part(body, finest_part * vertices, part_of(progress, 0, measuring_begins)).mesh,
        part_of(progress, measuring_begins, 1));
}

MatchedMap match(const MatchedBody& model, const SurfaceMesh& mesh, std::span<const glm::dvec3> points,
                 const glm::dmat3& turn, std::span<const Index> held, const MatchOptions& options,
                 const Progress& progress, const KeyJudge& judge) {
    SphereMesh body = normalized(mesh, points, turn);
    for (const Index vertex : held) body.landmarks.push_back({vertex, points[vertex]});
    turn_to_landmarks(body, model);
    const std::size_t vertices = even_vertices(options, points.size());
    const Progress begin = part_of(progress, 0, moving_begins * measuring_begins);
    const std::vector<std::array<Index, 2>> halved = split(body, vertices, begin);
    Match both(model, body, compared_part(body, finest_part * vertices, begin), vertices, options, progress);

    MatchReport report;
    report.before = both.figures_of(body.points);
    // A round body that is turned keeps its shapes. So places and normals must agree, too.
    const double disagreement = report.before.energy - MatchWeights().distortion * report.before.distortion;
    if (report.before.distortion < options.enough && disagreement < max_disagreement)
        return unmatched(std::move(report), "the maps agree already");
    const std::span<const Restoring> attempts =
        held.empty() ? std::span<const Restoring>(restorings) : restorings_with_landmarks;
    const double attempt = (1 - finishing_begins) / double(2 * attempts.size());  // both ways
    double part = finishing_begins;
    std::string fault = "there is no room for a vertex, or triangles turn over";
    for (const bool are_first : {true, false}) {
        std::vector<Candidate> candidates =
            are_first ? both.candidates(!held.empty()) : both.waiting_candidates(part);
        if (both.are_too_unlike()) return unmatched(std::move(report), "the bodies are too unlike");
        for (Candidate& candidate : candidates) {
            if (report.passes == 0) fault = "the matched map agrees no better";
            if (report.passes == 0) report.passes = candidate.passes;
            if (!(candidate.figures.energy < report.before.energy)) continue;
            const std::vector<glm::dvec3> first_points = candidate.points;
            for (const Restoring& restoring : attempts) {
                both.begin_part(part);
                part += attempt;
                if (restoring.begins_anew) candidate.points = first_points;
                if (restoring.worst_shape < worst_shape && !both.restore(restoring.worst_shape, candidate))
                    continue;
                if (!both.is_one_to_one(candidate) || !(candidate.figures.energy < report.before.energy))
                    continue;
                MatchedMap matched{.mesh = with_middles(mesh, halved, body.triangles),
                                   .points = candidate.points,
                                   .report = report};
                matched.report.after = candidate.figures;
                matched.report.passes = candidate.passes;
                const std::string fault_of_key =
                    judge ? judge(matched, part_of(progress, part - attempt, part)) : "";
                if (fault_of_key.empty()) {
                    both.begin_part(1);
                    return matched;
                }
                fault = "no good key: " + fault_of_key;
            }
        }
    }
    return unmatched(std::move(report), std::move(fault));
}

}  // namespace interleaf
