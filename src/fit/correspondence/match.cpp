#include "fit/correspondence/match.h"

#include <algorithm>
#include <array>
#include <span>
#include <utility>

#include "fit/correspondence/direction_insertion.h"
#include "fit/correspondence/even_mesh.h"
#include "fit/correspondence/finished_map.h"
#include "fit/correspondence/sphere_mesh.h"
#include "fit/correspondence/two_ways.h"
#include "fit/landmarks/similarity.h"
#include "fit/mesh/progress_meter.h"
#include "hierarchy/error.h"

namespace interleaf {
namespace {

/// Bodies with more vertices than this multiple of the even mesh's are compared on a coarser mesh.
constexpr std::size_t finest_part = 3;

/// Maps of a small distortion agree already if the rest of the energy, differences of places and normals, is below
/// this.
constexpr double max_disagreement = 0.01;

/// Where that gives no good key, more shapes are restored, and in more sweeps.
struct Restoring {
    double worst_shape;
    int sweeps = usual_sweeps;
    bool begins_anew = false;
};

/// The shapes of candidates are restored already.
constexpr Restoring as_it_is{.worst_shape = worst_kept_shape, .sweeps = 0};

/// Until shapes rest.
constexpr int many_sweeps = 1000;

/// First in one large step, which keeps more area between bone and sphere of the five keys, then from the first map
/// again in small ones, which more often give a good key.
constexpr std::array<Restoring, 5> restorings = {
    {as_it_is, {1.3}, {2, many_sweeps, true}, {1.3, many_sweeps}, {1, many_sweeps}}};

/// With landmarks, the worst shapes are often in long thin parts, such as a tail with a landmark at its tip. There, a
/// few sweeps do not suffice, and many in more places than necessary cost agreement.
constexpr std::array<Restoring, 5> restorings_with_landmarks = {
    {as_it_is, {worst_kept_shape, many_sweeps}, {2, 100}, {2, many_sweeps}, {1.3, many_sweeps}}};

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
        coarsened(body, finest_part * vertices, part_of(progress, 0, measuring_begins)).mesh,
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
    TwoWays both(model, body, coarsened(body, finest_part * vertices, begin), options.vertices,
                 {.vertices = vertices, .max_passes = options.max_passes, .enough = options.enough},
                 progress);

    MatchReport report;
    report.before = both.figures_of(body.points);
    // A round body that is turned keeps its shapes. So places and normals must agree, too.
    const double disagreement = report.before.energy - MatchWeights().distortion * report.before.distortion;
    if (report.before.distortion < options.enough && disagreement < max_disagreement)
        return unmatched(std::move(report), "the maps agree already");
    const std::span<const Restoring> attempts =
        held.empty() ? std::span<const Restoring>(restorings) : restorings_with_landmarks;
    double part = finishing_begins;
    std::string fault = "there is no room for a vertex, or triangles turn over";
    for (const bool are_first : {true, false}) {
        std::vector<Candidate> candidates = are_first ? both.candidates() : both.waiting_candidates(part);
        if (both.are_too_unlike()) return unmatched(std::move(report), "the bodies are too unlike");
        for (Candidate& candidate : candidates) {
            if (report.passes == 0) fault = "the matched map agrees no better";
            if (report.passes == 0) report.passes = candidate.passes;
            if (!(candidate.figures.energy < report.before.energy)) continue;
            const std::vector<glm::dvec3> first_points = candidate.points;
            for (const Restoring& restoring : attempts) {
                both.begin_part(part);
                const double begin_of_attempt = std::exchange(part, (1 + part) / 2);
                if (restoring.begins_anew) candidate.points = first_points;
                if (restoring.sweeps > 0 && !both.restore(restoring.worst_shape, restoring.sweeps, candidate))
                    continue;
                if (!both.is_one_to_one(candidate) || !(candidate.figures.energy < report.before.energy))
                    continue;
                MatchedMap matched{.mesh = with_middles(mesh, halved, body.triangles),
                                   .points = candidate.points,
                                   .report = report};
                matched.report.after = candidate.figures;
                matched.report.passes = candidate.passes;
                const std::string fault_of_key =
                    judge ? judge(matched, part_of(progress, begin_of_attempt, part)) : "";
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
